"""The energy barrier of heave and pitch, and the current up to which it keeps the ship.

Whoever is lost goes from the start to an exit: the ground, or the greatest trim. E = kinetic
energy + U is kept, so that a ship is safe whose energy is below the least height that every way out
must climb. That height is found on a grid of U, by the level at which the sea of all lower places
joins start and exit, and made exact by Newton's method at the saddle.
"""

from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np
from scipy.ndimage import label
from scipy.optimize import brentq, minimize_scalar, root

from squat.dynamics.lagrangian import Lagrangian
from squat.mesh import PositionError
from squat.quantities import Vector
from squat.trim.equilibria import Family
from squat.trim.region import HEAVES, Region

_TRIMS = 41
"""Points of the grid over pitch."""


class Pass(NamedTuple):
    """Lowest way out of the well: where (heave [m], pitch [rad]) and U there [J/m]."""

    heave: float
    pitch: float
    potential: float


@dataclass(frozen=True, eq=False)
class Barrier:
    """The ways out for a ship that starts from `start` (n,), in any current.

    Parameters
    ----------
    family
        The ship's energies.
    region
        Where it may be.
    start
        Heave [m] and pitch [rad] at rest.
    """

    family: Family
    region: Region
    start: Vector

    @cached_property
    def _places(self) -> Vector:
        """The grid's positions, shape (heaves, trims, 2); the first row is the ground."""
        trims = np.linspace(-self.region.pitch, self.region.pitch, _TRIMS)
        columns = [self.region.heaves(pitch) for pitch in trims.tolist()]
        return np.stack([np.array(columns).T, np.broadcast_to(trims, (HEAVES, _TRIMS))], axis=-1)

    @cached_property
    def _terms(self) -> tuple[Vector, Vector]:
        """U_0 and s of U = U_0 - lambda s on the grid, shape (heaves, trims) each."""
        found = np.array([self._split(q) for q in self._places.reshape(-1, 2)])
        still, moving = found.T.reshape(2, HEAVES, _TRIMS)
        return still, moving

    def _split(self, q: Vector) -> tuple[float, float]:
        still = self.family(0.0).potential(q)
        return still, 2 * (still - self.family(1.0).potential(q))

    def lowest(self, current: float) -> Pass:
        """The lowest pass at a current [m/s]."""
        system, (i, j) = self.family(current), self._saddle(current**2 / 2)
        q = self._places[i, j]
        at_exit = i == 0 or j in (0, _TRIMS - 1)
        return self._along_exit(system, i, j) if at_exit else self._exact(system, q)

    def _saddle(self, strength: float) -> tuple[int, int]:
        """Place on the grid where the start's well and an exit are first joined by all lower ones.

        From the well, not from the start: a start above the pass has a margin below zero.
        """
        still, moving = self._terms
        U = still - strength * moving
        apart = (self._places - self.start) / [self.region.submesh.limits.draft, self.region.pitch]
        well = _well(U, np.unravel_index(np.argmin((apart**2).sum(axis=-1)), U.shape))
        levels = np.sort(U[U[well] <= U])
        low, high = 0, len(levels) - 1
        while low < high:
            middle = (low + high) // 2
            joined = _joined(levels[middle] >= U, well)
            low, high = (low, middle) if joined else (middle + 1, high)
        i, j = np.argwhere(levels[low] == U)[0]
        return int(i), int(j)

    def _exact(self, system: Lagrangian, guess: Vector) -> Pass:
        """Saddle grad U = 0 near a place of the grid; that place where there is none."""
        scale = np.array([1.0, self.region.submesh.limits.draft])

        def force(x: Vector) -> Vector:
            return np.asarray(system.gradient(x / scale) / scale)

        try:
            found = root(force, guess * scale)
            q = np.asarray(found.x) / scale
            near = np.abs(q - guess) < [1.0, 4 * self.region.pitch / _TRIMS]
            if found.success and near.all():
                return Pass(float(q[0]), float(q[1]), float(system.potential(q)))
        except PositionError:
            pass
        return Pass(float(guess[0]), float(guess[1]), float(system.potential(guess)))

    def _along_exit(self, system: Lagrangian, i: int, j: int) -> Pass:
        """Least U on the exit between the neighbours of a place on it."""
        if i == 0:
            ends = self._places[0, [max(j - 1, 0), min(j + 1, _TRIMS - 1)]]
        else:
            ends = self._places[[i - 1, min(i + 1, HEAVES - 1)], j]

        def place(share: float) -> Vector:
            heave, pitch = (1 - share) * ends[0] + share * ends[1]
            return np.array([self.region.low(pitch) if i == 0 else heave, pitch])

        found = minimize_scalar(
            lambda share: system.potential(place(share)), bounds=(0, 1), method="bounded"
        )
        heave, pitch = place(float(found.x))
        return Pass(float(heave), float(pitch), float(found.fun))

    def margin(self, current: float) -> float:
        """Height of the lowest pass over the start [J/m]."""
        return self.lowest(current).potential - self.family(current).potential(self.start)

    def safe_speed(self, fastest: float) -> float:
        """Current [m/s] up to which the ship set free at rest cannot be lost, at most `fastest`."""
        if self.margin(0.0) <= 0:
            return 0.0
        if self.margin(fastest) > 0:
            return fastest
        return float(brentq(self.margin, 0.0, fastest, xtol=1e-5))


def _well(U: Vector, start: tuple[np.intp, ...]) -> tuple[np.intp, ...]:
    """Place where steepest descent on the grid `U` (heaves, trims) from `start` ends."""
    i, j = start
    while True:
        top, left = max(i - 1, np.intp(0)), max(j - 1, np.intp(0))
        near = U[top : i + 2, left : j + 2]
        if near.min() >= U[i, j]:
            return i, j
        down, right = np.unravel_index(np.argmin(near), near.shape)
        i, j = top + down, left + right


def _joined(sea: Vector, well: tuple[np.intp, ...]) -> bool:
    """Whether `sea` (heaves, trims) joins the well to the ground or to a greatest trim."""
    pools, _ = label(sea)
    exits = np.concatenate([pools[0], pools[:, 0], pools[:, -1]])
    return bool(np.any(exits == pools[well]))


def ridge(system: Lagrangian, region: Region, pitch: float) -> Pass:
    """Greatest U over heave at `pitch`, between grounding and the well's bottom."""
    w = region.heaves(pitch)
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
