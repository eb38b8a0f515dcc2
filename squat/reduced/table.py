"""Curves of heave as piecewise polynomials in plain floats: a microsecond an evaluation."""

import math
from collections.abc import Sequence

import numpy as np
from numpy.polynomial import Chebyshev
from scipy.interpolate import BPoly, PPoly

from squat.fluid.curves import Curves
from squat.mesh import GroundedError, PositionError
from squat.quantities import Vector

_PIECES = 400
"""Pieces over the curves' range: quintic, so that they follow the series to rounding."""


def pieces(knots: Vector, series: Chebyshev) -> Vector:
    """Quintic pieces of a `series`: coefficients (pieces, 6) in (u - knot), highest power first."""
    values = np.stack([series(knots), series.deriv()(knots), series.deriv(2)(knots)], axis=1)
    return np.asarray(PPoly.from_bernstein_basis(BPoly.from_derivatives(knots, values)).c.T)


class Quintics:
    """Functions of heave from quintic pieces in u = log(clearance), by their `series` in u.

    Parameters
    ----------
    series
        One for each function, all over the same range.
    clearance
        Under-keel clearance at w = 0 [m].
    """

    def __init__(self, series: Sequence[Chebyshev], clearance: float) -> None:
        self._clearance = clearance
        self._low, high = (float(end) for end in series[0].domain)
        self._least, self._greatest = math.exp(self._low), math.exp(high)
        self._step = (high - self._low) / _PIECES
        knots = np.linspace(self._low, high, _PIECES + 1)
        table = np.stack([pieces(knots, one) for one in series], axis=1)
        self._rows = [[tuple(row) for row in place] for place in table.tolist()]

    def holds(self, w: float) -> bool:
        """Whether heave `w` [m] lies in the range of the series."""
        return self._least <= self._clearance + w <= self._greatest

    def __call__(self, w: float) -> tuple[float, ...]:
        """Values at heave `w` [m]; beyond the range those of the outermost piece."""
        u = math.log(self._clearance + w) - self._low
        place = min(max(int(u / self._step), 0), _PIECES - 1)
        s = u - place * self._step
        return tuple(
            [
                a0 + s * (a1 + s * (a2 + s * (a3 + s * (a4 + s * a5))))
                for a5, a4, a3, a2, a1, a0 in self._rows[place]
            ]
        )


class HeaveTable:
    """a', b, c, c' over heave, from quintic pieces in u = log(clearance).

    a' and c' are the exact derivatives of the pieces, so that energy is kept to rounding.
    """

    def __init__(self, curves: Curves) -> None:
        self._beyond, self.clearance = curves.beyond, curves.clearance
        self.low, high = curves.logarithms
        self._least, self._greatest = math.exp(self.low), math.exp(high)
        knots = np.linspace(self.low, high, _PIECES + 1)
        self._step = (high - self.low) / _PIECES
        a, b, c = (pieces(knots, series) for series in curves.series)
        self._rows = [tuple(row) for row in np.hstack([a[:, :5], b, c]).tolist()]

    def __call__(self, w: float) -> tuple[float, float, float, float]:
        """Values a' [kg/m2], b, c [kg/m], c' [kg/m2] at heave `w` [m].

        Raises
        ------
        GroundedError
            Below the curves.
        PositionError
            Above them, or where w is not a number.
        """
        gap = self.clearance + w
        if not self._least <= gap <= self._greatest:
            raise self._refusal(w)
        u = math.log(gap) - self.low
        place = min(max(int(u / self._step), 0), _PIECES - 1)
        a5, a4, a3, a2, a1, b5, b4, b3, b2, b1, b0, c5, c4, c3, c2, c1, c0 = self._rows[place]
        s = u - place * self._step
        da = a1 + s * (2 * a2 + s * (3 * a3 + s * (4 * a4 + s * 5 * a5)))
        dc = c1 + s * (2 * c2 + s * (3 * c3 + s * (4 * c4 + s * 5 * c5)))
        b = b0 + s * (b1 + s * (b2 + s * (b3 + s * (b4 + s * b5))))
        c = c0 + s * (c1 + s * (c2 + s * (c3 + s * (c4 + s * c5))))
        return da / gap, b, c, dc / gap

    def _refusal(self, w: float) -> PositionError:
        error = self._beyond(w)
        return GroundedError(str(error)) if self.clearance + w < self._least else error
