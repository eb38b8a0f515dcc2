"""Dual norms of residuals without cancellation.

The residual r - K(q) V u is a combination of constant functionals g_l, one for each load and for
each term of K(q) times each basis function. Its norm is that of the same combination of their
Riesz representers X^-1 g_l. Squaring Gram matrices would lose half of the digits; coordinates in
an orthonormal basis of the representers lose none (Buhr, Engwer, Ohlberger, Rave 2014).
"""

from dataclasses import dataclass, field

import numpy as np
from scipy import sparse

from squat.fem import Factorised
from squat.quantities import Vector

_NEW = 1e-13
"""Share of a vector, beyond what the basis spans, that counts as rounding."""
_KEPT = 0.7
"""Share of its length that a vector keeps where it was orthogonal to the basis already."""


@dataclass(eq=False)
class OrthonormalBasis:
    """Vectors orthonormal in x^T X y, grown one by one; `vectors` (count, size)."""

    X: sparse.csc_array
    vectors: Vector

    @staticmethod
    def empty(X: sparse.csc_array) -> "OrthonormalBasis":
        """Basis without vectors."""
        return OrthonormalBasis(X, np.empty((0, int(X.shape[0]))))

    def add(self, y: Vector) -> Vector:
        """Coordinates (count,) of `y` in the basis, grown by what is new in it."""
        coordinates = np.zeros(len(self.vectors))
        rest = y
        size = new = self._norm(y)
        old = np.inf
        while _NEW * size < new < _KEPT * old:  # again, until nothing more is taken away
            part = self.vectors @ (self.X @ rest)
            rest = rest - part @ self.vectors
            coordinates += part
            old, new = new, self._norm(rest)
        if new > _NEW * size:
            self.vectors = np.vstack([self.vectors, rest / new])
            coordinates = np.append(coordinates, new)
        return coordinates

    def _norm(self, y: Vector) -> float:
        return float(np.sqrt(max(0.0, y @ (self.X @ y))))


@dataclass(eq=False)
class Representers:
    """Coordinates of the Riesz representers of functionals, in an orthonormal basis of them."""

    factor: Factorised
    basis: OrthonormalBasis
    rows: list[Vector] = field(default_factory=list)

    @staticmethod
    def of(factor: Factorised) -> "Representers":
        """For the inner product X that `factor` holds."""
        return Representers(factor, OrthonormalBasis.empty(factor.matrix))

    def add(self, functionals: Vector) -> None:
        """Add `functionals`, shape (k, size)."""
        X = self.factor
        for functional in functionals:
            representer = np.zeros(len(functional))
            representer[X.free] = X.factor.solve(functional[X.free])
            self.rows.append(self.basis.add(representer))

    def table(self) -> Vector:
        """Coordinates (basis, functionals): |sum_l c_l g_l| = |table @ c|."""
        table = np.zeros((len(self.basis.vectors), len(self.rows)))
        for place, row in enumerate(self.rows):
            table[: len(row), place] = row
        return table
