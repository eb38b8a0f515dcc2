"""The dynamic squat speed: the least current that loses a ship set free at w(0) with w'(0).

The ship is lost when its energy E = M w'^2/2 + U at the start reaches the barrier, the highest U
below it: the unstable equilibrium, or, at low speed, the place where it counts as grounded. Since
U = U_0(w) - V^2 s(w)/2 with s falling in w (the water's suction pulls the ship down everywhere),
E - U_barrier grows with V, and the speed is unique.
"""

import math

from squat.stability.branches import zero
from squat.stability.equilibria import Fold
from squat.stability.one_mode import Family, OneMode, energy
from squat.stability.orbits import barrier

_BEYOND = 1e-6
"""Share by which the search goes beyond the fold, where every start is lost."""


def margin(mode: OneMode, heave: float, velocity: float) -> float:
    """Energy [J/m] that a ship at `heave` [m] with `velocity` [m/s] lacks to be lost.

    Negative: it is lost.
    """
    return float(mode.potential(barrier(mode, heave))) - energy(mode, heave, velocity)


def dynamic_squat_speed(family: Family, fold: Fold, heave: float, velocity: float) -> float:
    """Dynamic squat speed [m/s] of a start at `heave` [m] with `velocity` [m/s].

    Zero where the ship grounds even in still water; the sign of the velocity is of no effect.

    Parameters
    ----------
    fold
        The 2D squat speed of the same family, an upper bound.
    """
    if velocity == 0 and heave < fold.sinkage:
        return _released_on_the_slope(family, fold, heave)

    def lack(V: float) -> float:
        return margin(family(V), heave, velocity)

    if lack(0.0) <= 0:
        return 0.0
    upper = fold.speed * (1 + _BEYOND)
    if lack(upper) > 0:
        return math.nan
    return zero(lack, 0.0, upper)


def _released_on_the_slope(family: Family, fold: Fold, heave: float) -> float:
    """Speed at which the unstable equilibrium passes a start at rest below the fold."""
    return zero(lambda V: family(V).slope(heave), 0.0, fold.speed)
