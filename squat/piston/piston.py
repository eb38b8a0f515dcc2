"""Piston and water column: masses, stiffness, exact motion, and the problem for the loop."""

import math
from dataclasses import dataclass as plain_dataclass
from typing import Annotated, Any

import numpy as np
from numpy.typing import ArrayLike
from pydantic.dataclasses import dataclass

from squat.coupling import Load
from squat.dynamics import Motion
from squat.quantities import (
    STRICT,
    Area,
    Length,
    NonNegative,
    Position,
    Ratio,
    Unit,
    Vector,
    Velocity,
)
from squat.water import Water


@dataclass(frozen=True, kw_only=True, config=STRICT)
class Piston:
    """A piston closing a U-tube of water (Fig. 1, Table 1).

    Parameters
    ----------
    length
        L [m], mean length of the water column.
    area
        S [m2], cross-section of the tube.
    mass_ratio
        m_f/m, water mass rho L S over piston mass.
    added_mass_ratio
        m_add/m_f, the correction of the corrected scheme.
    initial_position
        w(0) [m] from equilibrium, positive up.
    initial_velocity
        w'(0) [m/s].
    """

    length: Length
    area: Area
    mass_ratio: Ratio
    added_mass_ratio: Annotated[NonNegative, Unit("1")]
    initial_position: Position
    initial_velocity: Velocity


@plain_dataclass(frozen=True)
class Oscillator:
    """m w'' = F with F = -m_f w'' - k w, which is Eqs. (1)-(3): a `coupling.Problem`, n = 1.

    The weight m g cancels against the difference of the levels at rest, Eq. (3).
    """

    piston_mass: float
    fluid_mass: float
    stiffness: float
    """k = 2 rho g S [N/m]."""

    @classmethod
    def of(cls, piston: Piston, water: Water) -> "Oscillator":
        """Masses [kg] and stiffness [N/m] of `piston` in `water`."""
        fluid = water.density * piston.length * piston.area
        return cls(
            fluid / piston.mass_ratio, fluid, 2 * water.density * water.gravity * piston.area
        )

    @property
    def mass(self) -> Vector:
        """Piston mass as a matrix, shape (1, 1)."""
        return np.array([[self.piston_mass]])

    def load(self, trial: Motion, memory: Any, dt: float) -> Load:
        """Eq. (7): pressure force less weight."""
        return Load(-self.fluid_mass * trial.acceleration - self.stiffness * trial.position, None)

    def __call__(self, w: float) -> tuple[float, float, float, float]:
        """M = m + m_f, U = k w^2/2 and their slopes: piston and water as a `dynamics.OneMode`."""
        M, k = self.piston_mass + self.fluid_mass, self.stiffness
        return M, k * w * w / 2, 0.0, k * w

    @property
    def omega(self) -> float:
        """Angular frequency [rad/s] of Eq. (5)."""
        return math.sqrt(self.stiffness / (self.piston_mass + self.fluid_mass))

    def start(self, position: float, velocity: float) -> Motion:
        """Initial motion, with w'' from the coupled Eq. (4)."""
        state = np.array([position]), np.array([velocity])
        return Motion(*state, -(self.omega**2) * state[0])

    def exact(self, time: ArrayLike, start: Motion) -> Vector:
        """w(t) [m] of Eq. (5), for any initial velocity."""
        phase = self.omega * np.asarray(time)
        swing = start.velocity / self.omega * np.sin(phase)
        return np.asarray(start.position * np.cos(phase) + swing)

    def kinetic_energy(self, velocity: Vector) -> Vector:
        """(m + m_f) w'^2/2 [J]."""
        return np.asarray((self.piston_mass + self.fluid_mass) / 2 * velocity**2)

    def potential_energy(self, position: Vector) -> Vector:
        """rho g S w^2 [J]."""
        return np.asarray(self.stiffness / 2 * position**2)
