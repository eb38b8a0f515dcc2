"""The ship as a rigid body per unit width."""

from dataclasses import dataclass

import numpy as np

from squat.quantities import Vector


@dataclass(frozen=True)
class RigidBody:
    """M_s = diag(m, m, I_G) restricted to the modes, and the weight.

    Parameters
    ----------
    modes
        Degrees of freedom, in the order surge, heave, pitch.
    mass
        m [kg/m].
    inertia
        I_G about the pitch centre [kg m].
    gravity
        g [m/s2].
    """

    modes: tuple[str, ...]
    mass: float
    inertia: float
    gravity: float

    @property
    def matrix(self) -> Vector:
        """Structural mass matrix, shape (n, n)."""
        every = {"surge": self.mass, "heave": self.mass, "pitch": self.inertia}
        return np.diag([every[mode] for mode in self.modes])

    @property
    def weight(self) -> Vector:
        """Generalised force of gravity, shape (n,) [N/m]."""
        return np.array([-self.mass * self.gravity if m == "heave" else 0.0 for m in self.modes])
