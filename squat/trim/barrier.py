"""The energy barrier of heave and pitch, and the current up to which it keeps the ship.

Let w_r(theta) be any curve that separates the well from the bottom. Whoever is lost crosses it, or
leaves at the greatest trim; since E = kinetic energy + U is kept, a ship whose energy is below the
least of U on these lines is safe. The curve here is the ridge, the place of the greatest U over
heave at each trim: its least U is then a saddle, so no curve gives a better bound.
"""

from typing import NamedTuple

import numpy as np
from scipy.optimize import brentq, minimize_scalar

from squat.dynamics.lagrangian import Lagrangian
from squat.mesh import Submesh
from squat.mesh.limits import WALL
from squat.quantities import Vector
from squat.trim.equilibria import Family

_WALL = 1.01 * WALL
_SCAN, _TRIMS = 24, 15
"""Points over heave and over pitch between which extremes are refined."""


class Region(NamedTuple):
    """Where the ship may be.

    Parameters
    ----------
    submesh
        The hull over the bottom.
    pitch
        Greatest trim either way [rad].
    least
        Clearance [m] at which the ship counts as grounded.
    """

    submesh: Submesh
    pitch: float
    least: float

    def low(self, pitch: float) -> float:
        """Heave [m] at which the ship grounds at `pitch`."""
        return self.least - self.submesh.clearance(np.array([0.0, pitch]))

    def high(self, pitch: float) -> float:
        """Heave [m] up to which its vertical sides stay in the water at `pitch`."""
        limits = self.submesh.limits
        full = np.array([0.0, 0.0, pitch])
        top = self.submesh.motion.positions(full)[self.submesh.hull, 1].max()
        return float(min(limits.draft / 2, limits.level - top - _WALL * limits.wall))


class Pass(NamedTuple):
    """Lowest way out of the well: where (heave [m], pitch [rad]) and U there [J/m]."""

    heave: float
    pitch: float
    potential: float


def ridge(system: Lagrangian, region: Region, pitch: float) -> Pass:
    """Greatest U over heave at `pitch`, between grounding and the well's bottom."""
    w = np.linspace(region.low(pitch), region.high(pitch), _SCAN)
    U = np.array([system.potential(np.array([x, pitch])) for x in w])
    bottom = _bottom(U)
    top = int(np.argmax(U[: bottom + 1]))
    if top in (0, bottom):
        return Pass(float(w[top]), pitch, float(U[top]))
    found = minimize_scalar(
        lambda x: -system.potential(np.array([x, pitch])),
        bounds=(w[top - 1], w[top + 1]),
        method="bounded",
        options={"xatol": 1e-9},
    )
    return Pass(float(found.x), pitch, -float(found.fun))


def _bottom(U: Vector) -> int:
    """Place of the well: the first minimum from above; the lowest place where there is none."""
    for i in range(len(U) - 2, 0, -1):
        if U[i] <= U[i - 1]:
            return i
    return 0


def barrier(system: Lagrangian, region: Region) -> Pass:
    """Lowest point of the ridge and of the lines of greatest trim."""
    trims = np.linspace(-region.pitch, region.pitch, _TRIMS)
    found = [ridge(system, region, pitch) for pitch in trims.tolist()]
    least = min(range(_TRIMS), key=lambda i: found[i].potential)
    best = found[least]
    if 0 < least < _TRIMS - 1:
        refined = minimize_scalar(
            lambda pitch: ridge(system, region, float(pitch)).potential,
            bounds=(trims[least - 1], trims[least + 1]),
            method="bounded",
            options={"xatol": 1e-6},
        )
        best = min(best, ridge(system, region, float(refined.x)), key=lambda one: one.potential)
    edges = [edge(system, region, sign * region.pitch) for sign in (-1, 1)]
    return min(best, *edges, key=lambda one: one.potential)


def edge(system: Lagrangian, region: Region, pitch: float) -> Pass:
    """Least U over the heave of the well at a greatest trim: grounding lies beyond the ridge."""
    crest = ridge(system, region, pitch)
    found = minimize_scalar(
        lambda x: system.potential(np.array([x, pitch])),
        bounds=(crest.heave, region.high(pitch)),
        method="bounded",
    )
    return Pass(float(found.x), pitch, min(float(found.fun), crest.potential))


def safe_speed(family: Family, region: Region, start: Vector, fastest: float) -> float:
    """Current [m/s] up to which a ship released at rest from `start` (n,) cannot be lost.

    Parameters
    ----------
    fastest
        Current at which it has no well: the fold.
    """

    def lack(V: float) -> float:
        system = family(V)
        return barrier(system, region).potential - system.potential(start)

    if lack(0.0) <= 0:
        return 0.0
    return fastest if lack(fastest) > 0 else float(brentq(lack, 0.0, fastest, xtol=1e-5))
