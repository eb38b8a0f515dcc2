"""The structure solve of one coupling iteration."""

from dataclasses import dataclass
from functools import cached_property
from typing import Literal

import numpy as np

from squat.dynamics import Kinematics, Motion
from squat.quantities import Vector

SchemeName = Literal["standard", "corrected", "consistent"]


@dataclass(frozen=True)
class Scheme:
    """(M + m_add) q''^{k+1} = F(q^k) + m_add q''^k, Eqs. (12), (13), (16), (17).

    With m_add = 0 this is the standard scheme, Eq. (6).

    Parameters
    ----------
    mass
        M, shape (n, n).
    added_mass
        m_add, shape (n, n): any estimate; at convergence it cancels.
    """

    mass: Vector
    added_mass: Vector

    @cached_property
    def _inverse(self) -> Vector:
        return np.asarray(np.linalg.inv(self.mass + self.added_mass), float)

    def solve(self, force: Vector, trial: Motion, kinematics: Kinematics) -> Motion:
        """Motion of the structure under `force` (shape (n,)), the answer to `trial`."""
        acceleration = self._inverse.dot(force + self.added_mass.dot(trial.acceleration))
        return kinematics.at_acceleration(acceleration)


def standard(mass: Vector) -> Scheme:
    """Eq. (6): no correction."""
    return Scheme(mass, np.zeros_like(mass))


def corrected(mass: Vector, added_mass: Vector) -> Scheme:
    """Eq. (12): `added_mass` on both sides, shifted by one iteration."""
    return Scheme(mass, added_mass)
