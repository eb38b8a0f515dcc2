"""Phase portrait: the separatrix through the unstable equilibrium and what it encloses.

Inside the loop the ship oscillates for ever; with any damping it settles at the stable equilibrium,
since E cannot grow: the loop lies inside the basin of attraction whatever the damping, and is the
basin of bounded motion without it.
"""

import math
from typing import NamedTuple

import numpy as np

from squat.quantities import Vector
from squat.stability.branches import equilibria
from squat.stability.one_mode import OneMode
from squat.stability.orbits import orbit


class Separatrix(NamedTuple):
    """Upper half of the loop, from the barrier to where it turns; the lower half mirrors it.

    A loop that leaves the interval at the top ends there, and has no area (NaN).

    Parameters
    ----------
    heave, velocity
        Shape (points,) [m], [m/s >= 0].
    area
        Area of the loop in the plane of w and P = M w' [J s/m]: the action of its orbit.
    """

    heave: Vector
    velocity: Vector
    area: float


def well(mode: OneMode) -> tuple[float, float]:
    """Barrier and bottom of the well [m] that holds the highest stable equilibrium; NaN, NaN."""
    found = equilibria(mode)
    stable = [one.heave for one in found if one.stable]
    if not stable:
        return math.nan, math.nan
    below = [one.heave for one in found if not one.stable and one.heave < stable[-1]]
    return max([mode.interval.low, *below], key=mode.potential), stable[-1]


def separatrix(mode: OneMode, points: int) -> Separatrix:
    """Loop of the mode's well; NaN where there is none.

    Parameters
    ----------
    points
        Points of the half loop, denser at its ends.
    """
    top, bottom = well(mode)
    nothing = np.full(points, math.nan)
    if math.isnan(bottom):
        return Separatrix(nothing, nothing, math.nan)
    energy = float(mode.potential(top))
    lift = math.sqrt(2 * (energy - float(mode.potential(bottom))) / float(mode.mass(bottom)))
    turn = orbit(mode, bottom, lift).high
    leaves = math.isnan(turn)
    turn = mode.interval.high if leaves else turn
    half, angle = (turn - top) / 2, np.linspace(0, np.pi, points)
    heave = top + half * (1 - np.cos(angle))
    lack, mass = np.maximum(energy - mode.potential(heave), 0.0), mode.mass(heave)
    lack[[0] if leaves else [0, -1]] = 0.0
    momentum = np.sqrt(2 * mass * lack)
    # In the angle the integrand is smooth and periodic: the trapezoidal rule converges fast.
    area = 2 * float(np.trapezoid(momentum * half * np.sin(angle), angle))
    return Separatrix(heave, momentum / mass, math.nan if leaves else area)


def bounded(mode: OneMode, heave: float, velocity: float) -> bool:
    """Whether a ship set free there never grounds."""
    return not math.isnan(orbit(mode, heave, velocity).low)
