"""The reduced system: everything of full size projected beforehand.

    K_N(q) u_i = F_i(q),   K_N = sum_m theta_m K_N,m,   F_i = sum_l f_il s_N,l

with K_N,m = V^T K_m V and s_N,l = V^T s_l for the basis V of a few solutions.
"""

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from squat.mesh.motion import Index
from squat.quantities import Vector


class Affine(NamedTuple):
    """Coefficients at one position, or at several (leading axis).

    theta (terms,) of the stiffness; loads (flows, load terms): flow 0 is the current's, flow j
    that of mode j.
    """

    theta: Vector
    loads: Vector


@dataclass(frozen=True, eq=False)
class Galerkin:
    """Reduced system of the flows that share one Dirichlet set, N basis functions.

    Parameters
    ----------
    flows
        Which flows: 0 the current's, j that of mode j.
    stiffness
        K_N,m, shape (terms, N, N).
    loads
        s_N,l, shape (load terms, N).
    residual
        Coordinates of the residual's functionals, shape (rank, load terms + N terms).
    """

    flows: Index
    stiffness: Vector
    loads: Vector
    residual: Vector

    @property
    def size(self) -> int:
        """N, the number of basis functions."""
        return int(self.loads.shape[1])

    def matrix(self, theta: Vector) -> Vector:
        """K_N for theta (..., terms), shape (..., N, N)."""
        shape = (*theta.shape[:-1], self.size, self.size)
        return np.asarray(theta @ self.stiffness.reshape(len(self.stiffness), -1)).reshape(shape)

    def load(self, coefficients: Vector) -> Vector:
        """F_i of the own flows for load coefficients (..., flows, load terms)."""
        return np.asarray(coefficients[..., self.flows, :] @ self.loads)

    def solve(self, at: Affine) -> Vector:
        """Coefficients u of the own flows in the basis, shape (..., flows, N)."""
        return _solve(self.matrix(at.theta), self.load(at.loads))

    def energy(self, at: Affine, u: Vector) -> Vector:
        """phi_i^T K phi_j, symmetric, shape (..., flows, flows)."""
        product = self.load(at.loads) @ u.swapaxes(-1, -2)
        return np.asarray((product + product.swapaxes(-1, -2)) / 2)

    def energy_slopes(self, rate: Affine, u: Vector) -> Vector:
        """Derivative of the energies where the coefficients change at `rate`."""
        product = self.load(rate.loads) @ u.T
        return np.asarray(product + product.T - u @ self.matrix(rate.theta) @ u.T)

    def sensitivity(self, at: Affine, rate: Affine, u: Vector) -> Vector:
        """du where the coefficients change at `rate`, shape (flows, N)."""
        change = self.load(rate.loads) - u @ self.matrix(rate.theta)
        return _solve(self.matrix(at.theta), change)

    def residual_norms(self, at: Affine, u: Vector) -> Vector:
        """Dual norms of r_i - K V u_i, shape (..., flows)."""
        spread = -u[..., :, None] * at.theta[..., None, None, :]
        return self._norms(at.loads[..., self.flows, :], spread)

    def residual_rate_norms(self, at: Affine, rate: Affine, u: Vector, du: Vector) -> Vector:
        """Dual norms of the residual's derivative r_i' - K' V u_i - K V u_i', shape (flows,)."""
        spread = -u[..., None] * rate.theta - du[..., None] * at.theta
        return self._norms(rate.loads[self.flows], spread)

    def _norms(self, loads: Vector, spread: Vector) -> Vector:
        flat = spread.reshape(*spread.shape[:-2], -1)
        combination = np.concatenate([loads, flat], axis=-1)
        return np.asarray(np.linalg.norm(combination @ self.residual.T, axis=-1))


def _solve(matrix: Vector, rows: Vector) -> Vector:
    """Rows x of matrix x = row, for symmetric `matrix`."""
    return np.asarray(np.linalg.solve(matrix, rows.swapaxes(-1, -2)).swapaxes(-1, -2))
