"""K(q) phi = r at one position after another: assembly and factorisation that remember.

Between neighbouring positions K changes little. A factor is kept and serves as preconditioner of
conjugate gradients until that takes more than a few iterations; they start from the best
combination of the last solutions (Galerkin's: the least error in the energy norm).
"""

from dataclasses import dataclass, field
from functools import cached_property

import numpy as np
from scipy import sparse
from scipy.sparse.linalg import SuperLU, splu

from squat.fem import AffineStiffness, SolveError
from squat.mesh.motion import Index
from squat.quantities import Vector

TOLERANCE = 1e-12
"""Relative residual of a solution."""
_RECENT = 24
"""Solutions that a start vector is combined from."""
_INDEPENDENT = 1e-11
"""Share of a solution below which what is new in it counts as rounding."""
_PATIENCE = 7
"""Iterations after which a new factor is cheaper than the old one's help."""


@dataclass(eq=False)
class MovingSolver:
    """Solves with K(q) and zero values on `fixed`; remembers its last factor.

    Answers depend on what was asked before only within `TOLERANCE`.
    """

    affine: AffineStiffness
    fixed: Index
    solves: int = 0
    factorisations: int = 0
    residual: float = 0.0
    _factor: SuperLU | None = field(default=None, repr=False)
    _recent: Vector | None = field(default=None, repr=False)

    @cached_property
    def free(self) -> Index:
        """Degrees of freedom that are solved for."""
        return np.setdiff1d(np.arange(self.affine.space.size), self.fixed)

    @cached_property
    def _inner(self) -> tuple[sparse.csc_array, sparse.csr_array]:
        return self.affine.block(self.free)

    def forget(self) -> None:
        """Answer from now on as a new solver would, bit for bit."""
        self._factor = None
        self._recent = None

    def matrix(self, theta: Vector) -> sparse.csc_array:
        """Free block of sum theta_j K_j; its data last until the next call."""
        pattern, assemble = self._inner
        pattern.data = assemble @ theta
        return pattern

    def solve(self, theta: Vector, load: Vector) -> Vector:
        """Potential (size,) for `load` (size,).

        Raises
        ------
        SolveError
            Where the system is singular or the residual stays large.
        """
        matrix, right = self.matrix(theta), load[self.free]
        x = self._iterate(matrix, right, self._start(matrix, right))
        if x is None:
            self._factor = self._factorise(matrix)
            x = self._iterate(matrix, right, self._factor.solve(right))
        if x is None:
            raise SolveError("ill-conditioned system: conjugate gradients stall on a new factor")
        self.solves += 1
        self._remember(x)
        out = np.zeros(len(load))
        out[self.free] = x
        return out

    def _start(self, matrix: sparse.csc_array, right: Vector) -> Vector:
        basis = self._recent
        if basis is None:
            return np.zeros_like(right)
        projected = basis @ (matrix @ basis.T)
        return np.asarray(np.linalg.solve(projected, basis @ right) @ basis)

    def _remember(self, x: Vector) -> None:
        """Add the part of `x` that is new to the orthonormal basis of recent solutions."""
        size = float(np.sqrt(x @ x))
        basis = np.empty((0, len(x))) if self._recent is None else self._recent
        rest = x
        for _ in range(2):  # twice is enough
            rest = rest - (basis @ rest) @ basis
        if (new := float(np.sqrt(rest @ rest))) > _INDEPENDENT * size:
            self._recent = np.vstack([rest / new, basis[: _RECENT - 1]])

    def _factorise(self, matrix: sparse.csc_array) -> SuperLU:
        self.factorisations += 1
        if not np.all(np.isfinite(matrix.data)):
            raise SolveError("stiffness is not finite: a triangle of the mesh is flat")
        options = {"SymmetricMode": True}
        try:
            return splu(matrix, permc_spec="MMD_AT_PLUS_A", diag_pivot_thresh=0.0, options=options)
        except RuntimeError as error:
            raise SolveError(
                "singular system: the mesh is not tied to its Dirichlet set"
            ) from error

    def _iterate(self, matrix: sparse.csc_array, right: Vector, x: Vector) -> Vector | None:
        """Preconditioned conjugate gradients; None where patience ends."""
        if self._factor is None:
            return None
        scale = float(np.sqrt(right @ right)) or 1.0
        r = right - matrix @ x
        p, old = np.zeros_like(r), 1.0
        for _ in range(_PATIENCE):
            self.residual = float(np.sqrt(r @ r)) / scale
            if self.residual <= TOLERANCE:
                return x
            z = self._factor.solve(r)
            new = float(r @ z)
            p = z + (new / old) * p
            q = matrix @ p
            alpha = new / float(p @ q)
            x, r, old = x + alpha * p, r - alpha * q, new
        self.residual = float(np.sqrt(r @ r)) / scale
        return x if self.residual <= 10 * TOLERANCE else None
