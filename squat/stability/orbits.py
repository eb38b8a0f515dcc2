"""Free motion of one mode: how far it goes and how long it takes, without integrating in time."""

import math
from typing import NamedTuple

import numpy as np

from squat.stability.branches import equilibria, zero
from squat.stability.one_mode import OneMode, energy

_FEWEST, _MOST = 16, 2**16
_STEADY, _ROUNDING = 1e-12, 1e-7


class Orbit(NamedTuple):
    """Extremes of the motion [m] and its period [s].

    `low` is NaN where the ship is lost (it passes the barrier and grounds), `high` where it leaves
    the interval at the top; the period is NaN in both cases.
    """

    low: float
    high: float
    period: float


def barrier(mode: OneMode, start: float) -> float:
    """Heave [m] of the highest potential below `start`: an unstable root, or the interval's end."""
    below = [one.heave for one in equilibria(mode) if not one.stable and one.heave < start]
    return max([mode.interval.low, *below], key=mode.potential)


def orbit(mode: OneMode, heave: float, velocity: float) -> Orbit:
    """Motion that starts at `heave` [m] with `velocity` [m/s]."""
    stops = [one.heave for one in equilibria(mode)]
    down = _turn(mode, heave, velocity, [w for w in stops if w < heave][::-1], mode.interval.low)
    up = _turn(mode, heave, velocity, [w for w in stops if w > heave], mode.interval.high)
    return Orbit(down, up, period_between(mode, down, up))


def _turn(mode: OneMode, heave: float, velocity: float, stops: list[float], end: float) -> float:
    """First place on the way to `end` where U reaches the energy; NaN where it never does.

    `stops` are the extremes of U on the way: between two of them U is monotone.
    """
    if velocity == 0 and (end - heave) * float(mode.slope(heave)) >= 0:
        return heave  # released from rest, the ship goes the other way
    total, before = energy(mode, heave, velocity), heave
    for after in [*stops, end]:
        if mode.potential(after) > total:
            return zero(lambda w: mode.potential(w) - total, before, after)
        before = after
    return math.nan


def period_between(mode: OneMode, low: float, high: float) -> float:
    """Period [s] of the motion that turns at `low` and at `high` [m]; NaN where one is NaN.

    T = 2 int dw sqrt(M/(2 (E - U))): with w = middle + half cos(t) the roots at the turning points
    cancel, and Gauss-Chebyshev quadrature of the smooth rest converges geometrically. Points are
    doubled until the result stands to 1e-12 or rounding alone moves it.
    """
    if not low < high:
        return math.nan
    points, change = _FEWEST, math.inf
    value = _quadrature(mode, low, high, points)
    while points < _MOST:
        points *= 2
        last, value = value, _quadrature(mode, low, high, points)
        before, change = change, abs(value - last) / value
        if change <= _STEADY or before <= change < _ROUNDING:
            break
    return value


def _quadrature(mode: OneMode, low: float, high: float, points: int) -> float:
    total = (float(mode.potential(low)) + float(mode.potential(high))) / 2
    middle, half = (high + low) / 2, (high - low) / 2
    angle = np.pi * (np.arange(points) + 0.5) / points
    w = middle + half * np.cos(angle)
    lack = (total - mode.potential(w)) / (half * np.sin(angle)) ** 2
    sound = lack > 0  # rounding spoils the last digit of E - U beside a turning point
    return float(2 * np.pi * np.sqrt(mode.mass(w[sound]) / (2 * lack[sound])).mean())


def linear_period(mode: OneMode, heave: float) -> float:
    """Period [s] of small motion about the equilibrium `heave` [m]; NaN where it is unstable."""
    bend = stiffness(mode, heave)
    return 2 * math.pi * math.sqrt(float(mode.mass(heave)) / bend) if bend > 0 else math.nan


def stiffness(mode: OneMode, heave: float, step: float = 1e-3) -> float:
    """d2U/dw2 [N/m2]: a sixth-order difference of the slope over `step` of the way to the ends."""
    ends = mode.interval
    h = step * min(heave - ends.low, ends.high - heave)
    s = mode.slope(heave + h * np.array([-3.0, -2.0, -1.0, 1.0, 2.0, 3.0]))
    return float(s @ np.array([-1.0, 9.0, -45.0, 45.0, -9.0, 1.0]) / (60 * h))
