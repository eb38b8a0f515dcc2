"""Ship and water as one conservative system of few degrees of freedom."""

from typing import Protocol

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
