"""Many ships set free at once, each in its own current: full transients as arrays.

    w' = P/(m + c),   P' = c' w'^2/2 + V^2 (a' + rho L)/2 - rho g L w

by the classical Runge-Kutta rule, with steps of every ship's own: shorter near the bottom.
"""

from collections.abc import Iterator
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.polynomial.chebyshev import chebvander

from squat.fluid.curves import Curves
from squat.mesh.motion import Index
from squat.quantities import Vector

SAFE, GROUNDED, LIFTED, UNDECIDED = range(4)
_APPROACH = 0.05
"""Share of its clearance that a ship may sink in one step."""
_BISECTIONS = 50
_TINY = float(np.finfo(float).tiny)


class Fates(NamedTuple):
    """What became of each ship, shape (ships,).

    outcome: 0 safe (a whole oscillation without touching), 1 grounded, 2 lifted out of the model's
    reach, 3 undecided at the end; time [s] to that; least clearance [m]; energy [J/m] gained.
    """

    outcome: Index
    time: Vector
    clearance: Vector
    gain: Vector


@dataclass(frozen=True, eq=False)
class Fleet:
    """Equal ships over the water's `curves`.

    Parameters
    ----------
    mass
        m [kg/m].
    stiffness
        rho g L [N/m2].
    head
        rho L [kg/m2].
    lowest, highest
        Heave [m] at which a ship is grounded, or lifted.
    """

    curves: Curves
    mass: float
    stiffness: float
    head: float
    lowest: float
    highest: float

    def water(self, w: Vector) -> Vector:
        """a, c, a', c' at heaves `w` (ships,), shape (4, ships)."""
        gap = w + self.curves.clearance
        low, high = self.curves.logarithms
        x = (2 * np.log(gap) - low - high) / (high - low)
        value, slope, _ = self.curves.tables
        rows = np.vstack([value[[0, 2]], slope[[0, 2]]])
        found = rows @ chebvander(x, rows.shape[1] - 1).T
        found[2:] /= gap
        return np.asarray(found)

    def rates(self, w: Vector, P: Vector, V: Vector) -> tuple[Vector, Vector]:
        """w' and P'."""
        return self._rates(self.water(w), w, P, V)

    def _rates(self, water: Vector, w: Vector, P: Vector, V: Vector) -> tuple[Vector, Vector]:
        _, c, da, dc = water
        v = P / (self.mass + c)
        return v, dc * v**2 / 2 + V**2 / 2 * (da + self.head) - self.stiffness * w

    def energy(self, w: Vector, P: Vector, V: Vector) -> Vector:
        """P^2/(2 M) + U."""
        a, c, _, _ = self.water(w)
        spring = self.stiffness * w**2 / 2 - V**2 / 2 * (a + self.head * w)
        return np.asarray(P**2 / (2 * (self.mass + c)) + spring)

    def march(self, w: Vector, V: Vector, dt: float, end: float) -> Iterator[tuple[Index, Fates]]:
        """Set all free at rest; yields the numbers of ships that ended, and their fates.

        Parameters
        ----------
        w, V
            Heave at the start [m] and current [m/s], shape (ships,).
        dt
            Longest step [s].
        end
            Time [s] after which a ship is undecided.
        """
        ships = _start(self, w, V)
        while len(ships.number):
            ships, fates = self._step(ships, dt, end)
            over = fates.outcome >= 0
            yield ships.number[over], Fates._make(column[over] for column in fates)
            ships = _Ships._make(column[~over] for column in ships)

    def _step(self, ships: "_Ships", dt: float, end: float) -> tuple["_Ships", Fates]:
        w, P, V = ships.w, ships.P, ships.V
        water = self.water(w)
        k1 = self._rates(water, w, P, V)
        h = np.minimum(dt, self._within(_APPROACH * (w + self.curves.clearance), water, *k1))
        k2 = self.rates(w + h / 2 * k1[0], P + h / 2 * k1[1], V)
        k3 = self.rates(w + h / 2 * k2[0], P + h / 2 * k2[1], V)
        k4 = self.rates(w + h * k3[0], P + h * k3[1], V)
        new, momentum = (
            y + h / 6 * (a + 2 * b + 2 * c + d)
            for y, a, b, c, d in zip((w, P), k1, k2, k3, k4, strict=True)
        )
        speed = self.rates(new, momentum, V)[0]
        path = _Path(w, k1[0], new, speed, h)
        turned = (speed * k1[0] < 0) & (ships.time > 0)
        sunk, lifted = new < self.lowest, new > self.highest
        touch = np.where(sunk, path.reaches(self.lowest), 1.0)
        least = np.minimum(ships.least, np.where(turned, path.turn(), new))
        least = np.where(sunk, self.lowest, least)
        turns = ships.turns + turned
        time = ships.time + h * touch
        outcome = np.full(len(w), -1)
        for code, here in (
            (UNDECIDED, ~(time < end)),  # not a number is no time to go on for
            (SAFE, turns >= 2),
            (LIFTED, lifted),
            (GROUNDED, sunk),
        ):
            outcome[here] = code
        gain = self.energy(new, momentum, V) - ships.energy
        after = ships._replace(w=new, P=momentum, time=time, least=least, turns=turns)
        return after, Fates(outcome, time, least + self.curves.clearance, gain)

    def _within(self, way: Vector, water: Vector, v: Vector, force: Vector) -> Vector:
        """Time [s] in which ships go no further than `way` [m], at the rates `v`, `force` of now.

        The positive root of |v| h + |w''| h^2/2 = way.
        """
        _, c, _, dc = water
        fall = np.abs(force - dc * v**2) / (self.mass + c)
        pace = np.abs(v) + np.sqrt(v**2 + 2 * fall * way)
        return np.asarray(2 * way / np.maximum(pace, _TINY))


class _Ships(NamedTuple):
    """Ships still on their way, shape (ships,) each."""

    number: Index
    w: Vector
    P: Vector
    V: Vector
    time: Vector
    least: Vector
    turns: Index
    energy: Vector


class _Path(NamedTuple):
    """Cubic through both ends of a step: heave and velocity there, and its length [s]."""

    w0: Vector
    v0: Vector
    w1: Vector
    v1: Vector
    h: Vector

    def at(self, s: Vector) -> Vector:
        """Heave at the share `s` of the step."""
        start = (1 + 2 * s) * (1 - s) ** 2 * self.w0 + s * (1 - s) ** 2 * self.h * self.v0
        return start + s**2 * (3 - 2 * s) * self.w1 + s**2 * (s - 1) * self.h * self.v1

    def turn(self) -> Vector:
        """Heave where the velocity, linear in between, vanishes."""
        change = self.v0 - self.v1
        share = np.divide(self.v0, change, out=np.zeros_like(change), where=change != 0)
        return self.at(np.clip(share, 0, 1))

    def reaches(self, level: float) -> Vector:
        """Share of the step at which a sinking ship passes `level`, by bisection."""
        low, high = np.zeros_like(self.w0), np.ones_like(self.w0)
        for _ in range(_BISECTIONS):
            middle = (low + high) / 2
            above = self.at(middle) > level
            low, high = np.where(above, middle, low), np.where(above, high, middle)
        return high


def _start(fleet: Fleet, w: Vector, V: Vector) -> _Ships:
    zero = np.zeros_like(w)
    number = np.arange(len(w))
    return _Ships(number, w, zero, V, zero, w, np.zeros_like(number), fleet.energy(w, zero, V))
