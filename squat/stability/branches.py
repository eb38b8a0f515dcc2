"""Equilibria of one mode in a given current: dU/dw = 0."""

from collections.abc import Callable
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike
from scipy.optimize import brentq, minimize_scalar

from squat.quantities import Vector
from squat.stability.one_mode import OneMode

_SCAN = 160
"""Points of the scan; a pair of roots within one of its cells is found by the extreme between."""
_RELATIVE = 4 * float(np.finfo(float).eps)


def zero(function: Callable[[float], ArrayLike], left: float, right: float) -> float:
    """Root of `function` between two places where its signs differ, to machine accuracy."""
    found = brentq(
        lambda x: float(np.asarray(function(x))), left, right, xtol=1e-14, rtol=_RELATIVE
    )
    return float(found)


class Equilibrium(NamedTuple):
    """A place w [m] where the force vanishes, and whether U has a minimum there."""

    heave: float
    stable: bool


def equilibria(mode: OneMode) -> list[Equilibrium]:
    """All equilibria in the mode's interval, the deepest first.

    The slope is scanned; where it comes close to zero without crossing it, its extreme is sought
    too, so that a pair about to merge is not overlooked.
    """
    w, slope = _scan(mode)
    found = []
    for i in np.flatnonzero(slope[:-1] * slope[1:] < 0):
        root = zero(mode.slope, w[i], w[i + 1])
        found.append(Equilibrium(root, bool(slope[i + 1] > 0)))
    return found


def least_slope(mode: OneMode) -> tuple[float, float]:
    """Heave [m] at which dU/dw is least in the interval, and that least value [N/m]."""
    w = mode.interval.grid(_SCAN)
    slope = mode.slope(w)
    return _extreme(mode, w, slope, int(np.argmin(slope)), 1.0)


def _scan(mode: OneMode) -> tuple[Vector, Vector]:
    """Places in order and slopes there, with every extreme that may hide a pair of roots."""
    w = mode.interval.grid(_SCAN)
    slope = mode.slope(w)
    extra = []
    for sign in (1.0, -1.0):
        left, here, right = (sign * slope[i : len(w) - 2 + i] for i in range(3))
        hidden = np.flatnonzero((here > 0) & (here <= left) & (here < right)) + 1
        extra += [_extreme(mode, w, slope, int(i), sign) for i in hidden]
    if extra:
        more, values = np.array(extra).T
        w, slope = np.concatenate([w, more]), np.concatenate([slope, values])
    order = np.argsort(w, kind="stable")
    return w[order], slope[order]


def _extreme(mode: OneMode, w: Vector, slope: Vector, at: int, sign: float) -> tuple[float, float]:
    """The least of `sign` times the slope around sample `at`: place and slope."""
    bounds = w[max(at - 1, 0)], w[min(at + 1, len(w) - 1)]
    found = minimize_scalar(
        lambda x: sign * float(mode.slope(x)),
        bounds=bounds,
        method="bounded",
        options={"xatol": 1e-10},
    )
    if sign * slope[at] <= found.fun:
        return float(w[at]), float(slope[at])
    return float(found.x), float(sign * found.fun)
