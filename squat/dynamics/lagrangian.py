"""Ship and water as one conservative system of few degrees of freedom.

P = M(q) q',   q' = M^-1 P,   P' = -dE/dq + Gam q',   E = P^T M^-1 P/2 + U(q)
"""

from typing import Protocol

import numpy as np

from squat.dynamics.motion import Motion
from squat.quantities import Vector


class Lagrangian(Protocol):
    """System with energy E(q, P) = P^T M(q)^-1 P/2 + U(q) and a gyroscopic force.

    P = M q' and q' = M^-1 P, P' = -dE/dq + Gam q' in a constant current; Gam is antisymmetric, so
    E is kept. M is the ship's mass matrix plus the water's. Units per metre of width.
    """

    def mass(self, q: Vector) -> Vector:
        """M, shape (n, n) [kg/m; moments in kg m]."""
        ...

    def mass_gradient(self, q: Vector) -> Vector:
        """dM_ij/dq_k at [i, j, k], shape (n, n, n)."""
        ...

    def potential(self, q: Vector) -> float:
        """U [J/m]."""
        ...

    def gradient(self, q: Vector) -> Vector:
        """dU/dq, shape (n,) [N/m]."""
        ...

    def gyroscopic(self, q: Vector) -> Vector:
        """Gam, shape (n, n)."""
        ...


class OneMode(Protocol):
    """The same for one degree of freedom, in plain floats: long runs spend no time on arrays."""

    def __call__(self, w: float) -> tuple[float, float, float, float]:
        """M [kg/m], U [J/m], dM/dw, dU/dw at w."""
        ...


def inertial_force(gradient: Vector, velocity: Vector) -> Vector:
    """-sum_jk (dM_ij/dq_k - dM_jk/dq_i/2) q_j' q_k', shape (n,), from dM_ij/dq_k at [i, j, k]."""
    changing = gradient @ velocity @ velocity
    return np.asarray(np.tensordot(velocity @ gradient, velocity, (0, 0)) / 2 - changing)


def force(system: Lagrangian, motion: Motion, mass: Vector) -> Vector:
    """What moves a body of the constant matrix `mass` (n, n) as `system` moves, shape (n,).

    F = -dU/dq + Gam q' - (M - mass) q'' - (dM_ij/dq_k - dM_jk/dq_i/2) q_j' q_k'.
    """
    q, velocity, acceleration = motion
    free = inertial_force(system.mass_gradient(q), velocity) + system.gyroscopic(q) @ velocity
    return np.asarray(free - system.gradient(q) - (system.mass(q) - mass) @ acceleration)


def acceleration(system: Lagrangian, q: Vector, velocity: Vector) -> Vector:
    """q'' (n,) of the free motion through q with velocity q'."""
    still = force(system, Motion(q, velocity, np.zeros_like(q)), np.zeros((len(q), len(q))))
    return np.asarray(np.linalg.solve(system.mass(q), still), float)


def energy(system: Lagrangian, q: Vector, velocity: Vector) -> float:
    """E = q'^T M q'/2 + U [J/m]."""
    return float(velocity @ system.mass(q) @ velocity) / 2 + system.potential(q)
