"""a(w), b(w), c(w) of heave as smooth curves, from a score of solves.

They are analytic in the logarithm of the under-keel clearance; Chebyshev points there converge
geometrically. Slopes cost no solve, so each point gives two conditions: n points make series of
2 n terms.
"""

import math
from dataclasses import dataclass, field
from functools import cached_property
from typing import Protocol

import numpy as np
from numpy.polynomial import Chebyshev, chebyshev
from numpy.typing import ArrayLike

from squat.fluid.model import Coefficients, EnergyModel, FreeSurface, Slopes
from squat.mesh import Mesh, PositionError
from squat.quantities import Vector

POINTS = 16
"""Solved positions: values to 1e-9, slopes to 1e-7 over five e-foldings of the clearance."""
SLACK = 1e-12
"""Rounding allowed beyond the ends, over half the range."""


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
    _last: dict[float, tuple[Vector, Vector]] = field(default_factory=dict, init=False, repr=False)

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

    @cached_property
    def ends(self) -> tuple[float, float]:
        """Least and greatest w [m]."""
        low, high = self.logarithms
        return math.exp(low) - self.clearance, math.exp(high) - self.clearance

    @cached_property
    def logarithms(self) -> tuple[float, float]:
        """Logarithms of the least and the greatest clearance."""
        low, high = self.series[0].domain
        return float(low), float(high)

    @cached_property
    def tables(self) -> tuple[Vector, Vector, Vector]:
        """Coefficients of a, b, c and of their first and second derivatives, (3, terms) each."""
        rows = [
            [s.deriv(order).coef if order else s.coef for s in self.series] for order in range(3)
        ]
        terms = len(self.series[0])
        value, first, second = (
            np.array([np.pad(row, (0, terms - len(row))) for row in three]) for three in rows
        )
        return value, first, second

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
        _, basis = self._at(w)
        return np.asarray(self.tables[0] @ basis).reshape(3, *np.shape(w))

    def first(self, w: ArrayLike) -> Vector:
        """da/dw, db/dw, dc/dw, shape (3, ...)."""
        gap, basis = self._at(w)
        return np.asarray(self.tables[1] @ basis / gap).reshape(3, *np.shape(w))

    def second(self, w: ArrayLike) -> Vector:
        """Second derivatives, shape (3, ...)."""
        gap, basis = self._at(w)
        bend = (self.tables[2] - self.tables[1]) @ basis / gap**2
        return np.asarray(bend).reshape(3, *np.shape(w))

    def _at(self, w: ArrayLike) -> tuple[Vector, Vector]:
        """Clearance (points,) and T_k (terms, points) at w, kept for the last single one."""
        if np.size(w) != 1:
            return self._basis(w)
        key = float(np.ravel(w)[0])
        if key not in self._last:
            found = self._basis(w)
            self._last.clear()
            self._last[key] = found
        return self._last[key]

    def _basis(self, w: ArrayLike) -> tuple[Vector, Vector]:
        """Clearance at w and T_k = cos(k arccos x)."""
        gap = np.ravel(np.asarray(w, float)) + self.clearance
        low, high = self.logarithms
        with np.errstate(invalid="ignore", divide="ignore"):
            x = (2 * np.log(gap) - low - high) / (high - low)
        if not np.all(np.abs(x) <= 1 + SLACK):
            raise self.beyond(float(gap[~(np.abs(x) <= 1 + SLACK)][0]) - self.clearance)
        angle = np.arccos(np.clip(x, -1, 1))
        return gap, np.cos(np.arange(len(self.series[0]))[:, None] * angle)

    def beyond(self, w: float) -> PositionError:
        """The error of a position where the series mean nothing."""
        low, high = self.ends
        return PositionError(f"heave={w:g}: beyond the curves, {low:.6g} to {high:.6g} m")


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
