"""The ship as a rigid body per unit width: its inertia, its weight, its mooring."""

import math
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from squat.quantities import Vector


@dataclass(frozen=True)
class RigidBody:
    """Mass matrix M_s(q) of the modes and the weight, for pitch about any point.

    Parameters
    ----------
    modes
        Degrees of freedom, in the order surge, heave, pitch.
    mass
        m [kg/m].
    inertia
        I about the pitch centre [kg m].
    gravity
        g [m/s2].
    offset
        Centre of mass less pitch centre at rest (x, z) [m]; (0, 0) makes M_s constant.
    mooring
        Stiffness of a spring on surge [N/m2].
    """

    modes: tuple[str, ...]
    mass: float
    inertia: float
    gravity: float
    offset: tuple[float, float] = (0.0, 0.0)
    mooring: float = 0.0

    @property
    def matrix(self) -> Vector:
        """Structural mass matrix at rest, shape (n, n)."""
        return self.mass_matrix(np.zeros(len(self.modes)))

    def potential(self, q: Vector) -> float:
        """Energy of weight and mooring, m g z_G + k s^2/2, from its value at q = 0 [J/m]."""
        rise = self.height(q) - self.height(np.zeros_like(q))
        return self.mass * self.gravity * rise + self.mooring * self._surge(q) ** 2 / 2

    def gradient(self, q: Vector) -> Vector:
        """Its derivatives, shape (n,) [N/m]: minus the generalised force."""
        if not self._translates:
            return self.mass * self.gravity * self.height_gradient(q) + self._stiffness * q
        return self._weight + self._stiffness * q if self.mooring else self._weight

    @cached_property
    def _translates(self) -> bool:
        return "pitch" not in self.modes

    @cached_property
    def _weight(self) -> Vector:
        """m g dz_G/dq_i, shape (n,): the same everywhere for a ship that does not turn."""
        return self.mass * self.gravity * self.height_gradient(np.zeros(len(self.modes)))

    @cached_property
    def _stiffness(self) -> Vector:
        """Of the mooring, mode by mode, shape (n,) [N/m2]."""
        return np.array([self.mooring, 0.0, 0.0])[self._free]

    def mass_matrix(self, q: Vector) -> Vector:
        """M_s(q), shape (n, n): the centre of mass moves with (s', w') + theta' (-e_z, e_x)."""
        x, z = self._arm(q)
        m = self.mass
        full = np.array([[m, 0.0, -m * z], [0.0, m, m * x], [-m * z, m * x, self.inertia]])
        return full[np.ix_(self._free, self._free)]

    def mass_gradient(self, q: Vector) -> Vector:
        """dM_s,ij/dq_k at [i, j, k], shape (n, n, n): only pitch changes M_s."""
        out = np.zeros((len(self.modes),) * 3)
        if "pitch" in self.modes:
            x, z = self._arm(q)
            m = self.mass
            full = np.array([[0.0, 0.0, -m * x], [0.0, 0.0, -m * z], [-m * x, -m * z, 0.0]])
            out[:, :, self.modes.index("pitch")] = full[np.ix_(self._free, self._free)]
        return out

    def height(self, q: Vector) -> float:
        """Height of the centre of mass over the rest position of the pitch centre [m]."""
        heave = float(q[self.modes.index("heave")]) if "heave" in self.modes else 0.0
        return heave + self._arm(q)[1]

    def height_gradient(self, q: Vector) -> Vector:
        """dz_G/dq_i, shape (n,)."""
        full = np.array([0.0, 1.0, self._arm(q)[0]])
        return full[self._free]

    def _surge(self, q: Vector) -> float:
        return float(q[self.modes.index("surge")]) if "surge" in self.modes else 0.0

    @property
    def _free(self) -> list[int]:
        return [("surge", "heave", "pitch").index(mode) for mode in self.modes]

    def _arm(self, q: Vector) -> tuple[float, float]:
        """Centre of mass less pitch centre (x, z) [m], turned by the pitch of q."""
        x, z = self.offset
        angle = float(q[self.modes.index("pitch")]) if "pitch" in self.modes else 0.0
        cos, sin = math.cos(angle), math.sin(angle)
        return cos * x - sin * z, sin * x + cos * z
