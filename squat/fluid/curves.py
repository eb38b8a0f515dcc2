"""a(w), b(w), c(w) of heave as smooth curves, from a score of solves.

They are analytic in the logarithm of the under-keel clearance; Chebyshev points there converge
geometrically. Slopes cost no solve, so each point gives two conditions: n points make series of
2 n terms.
"""

from dataclasses import dataclass
from typing import Protocol

import numpy as np
from numpy.polynomial import Chebyshev, chebyshev
from numpy.typing import ArrayLike

from squat.fluid.model import Coefficients, EnergyModel, FreeSurface, Slopes
from squat.mesh import Mesh, PositionError
from squat.quantities import Vector

POINTS = 16
"""Solved positions: values to 1e-9, slopes to 1e-7 over five e-foldings of the clearance."""


class Meshed(EnergyModel, Protocol):
    """An energy model that is computed on a mesh."""

    @property
    def mesh(self) -> Mesh:
        """The mesh, whose submesh knows the clearance."""
        ...


@dataclass(frozen=True, eq=False)
class Curves:
    """Energy coefficients over heave w [m] and their derivatives: an `EnergyModel` of one mode.

    Parameters
    ----------
    clearance
        Under-keel clearance at w = 0 [m].
    series
        Chebyshev series of a, b, c [kg/m] in the logarithm of the clearance.
    free_surface
        That of the flow behind the curves.
    """

    clearance: float
    series: tuple[Chebyshev, Chebyshev, Chebyshev]
    free_surface: FreeSurface

    @staticmethod
    def of(fluid: Meshed, low: float, high: float, points: int = POINTS) -> "Curves":
        """Curves from `points` positions between w = `low` and w = `high` [m]."""
        clearance = fluid.mesh.submesh.limits.clearance
        ends = np.log([clearance + low, clearance + high])
        half = (ends[1] - ends[0]) / 2
        nodes = chebyshev.chebpts1(points)
        gap = np.exp(ends.mean() + half * nodes)
        rows = np.array([_row(fluid, w) for w in gap - clearance])
        values, slopes = rows[:, :3], rows[:, 3:] * (half * gap)[:, None]
        fitted = _hermite(nodes, values, slopes)
        a, b, c = (Chebyshev(column, domain=ends, window=[-1, 1]) for column in fitted.T)
        return Curves(clearance, (a, b, c), fluid.free_surface)

    @property
    def ends(self) -> tuple[float, float]:
        """Least and greatest w [m]."""
        low, high = np.exp(self.series[0].domain) - self.clearance
        return float(low), float(high)

    def coefficients(self, position: Vector) -> Coefficients:
        """Energy coefficients at `position`, shape (1,); PositionError beyond the curves' ends."""
        a, b, c = self.values(position)
        return Coefficients(float(a[0]), b, c[:, None])

    def slopes(self, position: Vector) -> Slopes:
        """Their derivatives by w."""
        a, b, c = self.first(position)
        return Slopes(a, b[:, None], c[:, None, None])

    def values(self, w: ArrayLike) -> Vector:
        """a, b, c at w (...), shape (3, ...)."""
        u = np.log(self._gap(w))
        return np.array([s(u) for s in self.series])

    def first(self, w: ArrayLike) -> Vector:
        """da/dw, db/dw, dc/dw, shape (3, ...)."""
        gap = self._gap(w)
        return np.array([s.deriv()(np.log(gap)) / gap for s in self.series])

    def second(self, w: ArrayLike) -> Vector:
        """Second derivatives, shape (3, ...)."""
        gap = self._gap(w)
        u = np.log(gap)
        return np.array([(s.deriv(2)(u) - s.deriv()(u)) / gap**2 for s in self.series])

    def _gap(self, w: ArrayLike) -> Vector:
        """Clearance at w [m]; raises PositionError beyond the ends, where series mean nothing."""
        w, (low, high) = np.asarray(w, float), self.ends
        slack = 1e-9 * self.clearance
        if not np.all((w >= low - slack) & (w <= high + slack)):
            raise PositionError(
                f"heave={np.array2string(w, threshold=3)}: beyond the curves, which go from "
                f"{low:.4g} to {high:.4g} m"
            )
        return w + self.clearance


def _row(fluid: EnergyModel, w: float) -> Vector:
    """a, b, c and da/dw, db/dw, dc/dw at one position, shape (6,)."""
    q = np.array([w])
    return np.concatenate([np.ravel(part) for part in (*fluid.coefficients(q), *fluid.slopes(q))])


def _hermite(x: Vector, values: Vector, slopes: Vector) -> Vector:
    """Chebyshev coefficients (2 n, k) with `values` and `slopes` (n, k) at Chebyshev points x."""
    n = len(x)
    basis = chebyshev.chebvander(x, 2 * n - 1)
    rates = chebyshev.chebvander(x, 2 * n - 2) @ chebyshev.chebder(np.eye(2 * n))
    # T_k' = k U_{k-1} and sqrt(1 - x^2) |U| <= 1: with this scale the condition number is 2.
    scale = np.sqrt(1 - x**2)[:, None] / n
    matrix, right = np.vstack([basis, rates * scale]), np.vstack([values, slopes * scale])
    return np.asarray(np.linalg.solve(matrix, right), float)
