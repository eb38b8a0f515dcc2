"""The 2D squat speed: the current at which the stable and the unstable equilibrium merge.

Below it there are places where the net force points up (dU/dw < 0); above it there is none. The
least slope over w therefore changes sign at the fold, where dU/dw = d2U/dw2 = 0.
"""

from squat.errors import InputError
from squat.stability.branches import least_slope, zero
from squat.stability.equilibria import Fold
from squat.stability.one_mode import Family

FASTEST = 1e3
"""Current [m/s] beyond which no fold is sought."""
_WIDTH = 1e-9


def squat_speed(family: Family) -> Fold:
    """Fold of the equilibria over the current, bracketed to 1e-8 m/s or better.

    Raises
    ------
    InputError
        Where the ship keeps an equilibrium at every speed.
    """

    def least(V: float) -> float:
        return least_slope(family(V))[1]

    upper = 1.0
    while least(upper) < 0:
        upper *= 2
        if upper > FASTEST:
            raise InputError(
                f"channel.depth: no squat speed below {FASTEST:g} m/s, the ship keeps an "
                "equilibrium; give a shallower channel"
            )
    speed = zero(least, 0.0, upper)
    half = _WIDTH / 2
    while not least(speed - half) < 0 < least(speed + half):
        half *= 2
    return Fold(speed, 2 * half, least_slope(family(speed))[0])
