"""Sparse solves that state their residual, and refuse a system that has no solution."""

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from scipy import sparse
from scipy.sparse.linalg import SuperLU, splu

from squat.errors import InputError
from squat.mesh.motion import Index
from squat.quantities import Vector

RESIDUAL = 1e-9
"""Largest relative residual of a solution, unless rounding alone leaves more."""
_ROUNDING = 4 * float(np.finfo(float).eps)
_PIVOT = 1e-14
"""Smallest pivot over the largest, below which a matrix counts as singular."""


class SolveError(InputError, ArithmeticError):
    """A linear system that is singular or too ill-conditioned; the message names the cause."""


class Solution(NamedTuple):
    """Solutions (n,) or (k, n), and the largest relative residual |K x - b| / |b|."""

    values: Vector
    residual: float


@dataclass(frozen=True, eq=False)
class Factorised:
    """Symmetric K with Dirichlet values on `fixed`, factorised once for many right-hand sides."""

    matrix: sparse.csc_array
    fixed: Index
    free: Index
    factor: SuperLU

    @staticmethod
    def of(matrix: sparse.csc_array, fixed: Index) -> "Factorised":
        """Factorise; raises SolveError naming why that is impossible."""
        size = int(matrix.shape[0])
        if len(fixed) == 0:
            raise SolveError(
                "singular system: no boundary holds the potential (Dirichlet set empty)"
            )
        if not np.all(np.isfinite(matrix.data)):
            raise SolveError("stiffness is not finite: a triangle of the mesh is flat")
        free = np.setdiff1d(np.arange(size), fixed)
        inner = sparse.csc_array(matrix[free][:, free])
        try:
            factor = splu(
                inner,
                permc_spec="MMD_AT_PLUS_A",
                diag_pivot_thresh=0.0,
                options={"SymmetricMode": True},
            )
        except RuntimeError as error:
            raise SolveError(
                "singular system: part of the mesh is not tied to the Dirichlet set"
            ) from error
        pivots = np.abs(factor.U.diagonal())
        if pivots.min() < _PIVOT * pivots.max():
            raise SolveError(
                f"ill-conditioned system: pivots from {pivots.min():.1e} to {pivots.max():.1e}; "
                "the mesh is nearly flat somewhere, or not tied to the Dirichlet set"
            )
        return Factorised(matrix, fixed, free, factor)

    def solve(self, loads: Vector, held: Vector | None = None) -> Solution:
        """Solve K x = load for loads (n,) or (k, n), with x = `held` (n,) on the Dirichlet set.

        Raises
        ------
        SolveError
            Where the relative residual exceeds 1e-9 and what rounding of |K| |x| leaves: on meshes
            squeezed to a fiftieth of their height that is as much.
        """
        rows = np.atleast_2d(loads)
        x = np.zeros(rows.shape)
        if held is not None:
            x[:, self.fixed] = held[self.fixed]
        b = (rows - x @ self.matrix)[:, self.free]
        x[:, self.free] = self.factor.solve(np.ascontiguousarray(b.T)).T
        rest = (rows - x @ self.matrix)[:, self.free]
        scale = np.maximum(np.linalg.norm(b, axis=1), np.finfo(float).tiny)
        residual = float((np.linalg.norm(rest, axis=1) / scale).max(initial=0.0))
        if not residual <= RESIDUAL and not residual <= self._rounding(x, scale):
            raise SolveError(
                f"relative residual {residual:.1e} exceeds {RESIDUAL:.0e}: ill-conditioned mesh "
                "or right-hand side that is not finite"
            )
        return Solution(x[0] if loads.ndim == 1 else x, residual)

    def _rounding(self, x: Vector, scale: Vector) -> float:
        """Relative residual that an exact solution rounded to double precision may have."""
        reach = np.linalg.norm((np.abs(x) @ abs(self.matrix))[:, self.free], axis=1)
        return float((_ROUNDING * reach / scale).max(initial=0.0))
