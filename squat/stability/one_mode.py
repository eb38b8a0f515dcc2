"""A conservative system of one coordinate w on an interval: what this room's algorithms work on."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Protocol

import numpy as np
from numpy.typing import ArrayLike

from squat.dynamics.lagrangian import Lagrangian
from squat.quantities import Vector


@dataclass(frozen=True)
class Interval:
    """Heave [m] that is covered: at `low` the ship counts as grounded."""

    low: float
    high: float

    def grid(self, points: int) -> Vector:
        """Heave at `points` places, denser towards both ends, shape (points,)."""
        share = (1 - np.cos(np.linspace(0, np.pi, points))) / 2
        return np.asarray(self.low + (self.high - self.low) * share)


class OneMode(Protocol):
    """M w'^2/2 + U(w) per metre of width; every function works elementwise on heave [m]."""

    @property
    def interval(self) -> Interval:
        """Where it may be evaluated."""
        ...

    def mass(self, w: ArrayLike) -> Vector:
        """M(w) [kg/m]."""
        ...

    def potential(self, w: ArrayLike) -> Vector:
        """U(w) [J/m]."""
        ...

    def slope(self, w: ArrayLike) -> Vector:
        """dU/dw [N/m]: minus the force."""
        ...


Family = Callable[[float], OneMode]
"""The system in a steady current of so many m/s."""


def energy(mode: OneMode, heave: float, velocity: float) -> float:
    """E = M w'^2/2 + U [J/m]."""
    return float(mode.mass(heave)) * velocity**2 / 2 + float(mode.potential(heave))


@dataclass(frozen=True)
class Along:
    """Any `Lagrangian` along one of its coordinates, the others held: a `OneMode`.

    Parameters
    ----------
    system
        Of n modes.
    interval
        Of the coordinate.
    place
        Which coordinate moves.
    held
        All coordinates, shape (n,); that of `place` is ignored.
    """

    system: Lagrangian
    interval: Interval
    place: int = 0
    held: tuple[float, ...] = (0.0,)

    def mass(self, w: ArrayLike) -> Vector:
        """See `OneMode.mass`."""
        return self._each(w, lambda q: float(self.system.mass(q)[self.place, self.place]))

    def potential(self, w: ArrayLike) -> Vector:
        """See `OneMode.potential`."""
        return self._each(w, self.system.potential)

    def slope(self, w: ArrayLike) -> Vector:
        """See `OneMode.slope`."""
        return self._each(w, lambda q: float(self.system.gradient(q)[self.place]))

    def _each(self, w: ArrayLike, function: Callable[[Vector], float]) -> Vector:
        def at(one: float) -> float:
            q = np.array(self.held, float)
            q[self.place] = one
            return function(q)

        return np.asarray(np.vectorize(at, otypes=[float])(w))
