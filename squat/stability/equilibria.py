"""Squat equilibria of the one-dimensional model, Eq. (27).

The water under the hull flows at V H / (H - T + w), uniformly, so that

    (m + m_add) w'' = -rho g L w + rho L V^2/2 (1 - H^2/(H - T + w)^2) = P(w) / (H - T + w)^2

with the cubic P = A1 w^3 + A2 w^2 + A3 w + A4. (The printed Eq. (27) lacks the denominator.)
"""

import math
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike
from scipy.optimize import brentq

from squat.channel import Channel, Hull, check_afloat
from squat.quantities import Vector
from squat.stability.keel import keel_pressure
from squat.water import Water


class Roots(NamedTuple):
    """Roots w [m] of Eq. (27), NaN where a root does not exist; shape of the speeds."""

    stable: Vector
    unstable: Vector
    unphysical: Vector


class Fold(NamedTuple):
    """The double root: squat speed [m/s], its bracket's width [m/s], and its sinkage [m]."""

    speed: float
    width: float
    sinkage: float


@dataclass(frozen=True)
class OneDimensionalModel:
    """Eq. (27) for one hull in one channel, per unit width."""

    hull: Hull
    channel: Channel
    water: Water

    def __post_init__(self) -> None:
        check_afloat(self.hull, self.channel)

    @property
    def clearance(self) -> float:
        """H - T [m], the under-keel clearance at rest."""
        return self.channel.depth - self.hull.draft

    def force(self, w: ArrayLike, speed: ArrayLike) -> Vector:
        """Net vertical force [N/m] at heave `w` [m] and `speed` [m/s], elementwise."""
        w = np.asarray(w, float)
        rho, g, L = self.water.density, self.water.gravity, self.hull.length
        suction = keel_pressure(rho, speed, self.channel.depth, self.clearance + w)
        return np.asarray(-rho * g * L * w + L * suction)

    def stiffness(self, w: ArrayLike, speed: ArrayLike) -> Vector:
        """Restoring slope -dF/dw [N/m2], elementwise; positive: stable.

        Minus infinity on the bottom, where the lower root of V -> 0 ends.
        """
        w, V = np.asarray(w, float), np.asarray(speed, float)
        rho, g, L = self.water.density, self.water.gravity, self.hull.length
        gap = self.clearance + w
        suction = np.full(np.broadcast(V, gap).shape, np.inf)
        np.divide((V * self.channel.depth) ** 2, gap**3, out=suction, where=gap != 0)
        return rho * L * (g - suction)

    def coefficients(self, speed: ArrayLike) -> Vector:
        """A1..A4 of Eq. (27) over rho L, shape (..., 4) for speeds of shape (...)."""
        V2, g = np.asarray(speed, float) ** 2, self.water.gravity
        h, H = self.clearance, self.channel.depth
        ones = np.ones_like(V2)
        terms = (-g * ones, V2 / 2 - 2 * g * h, V2 * h - g * h**2, V2 / 2 * (h**2 - H**2))
        return np.stack(terms, axis=-1)

    def roots(self, speed: ArrayLike) -> Roots:
        """All roots at once; at V = 0 the two lower ones meet on the bottom.

        With u = H - T + w (the clearance), P = 0 reads u^3 - q u^2 + r = 0 with
        q = H - T + V^2/(2 g) and r = V^2 H^2/(2 g): a cubic whose three real roots, where they
        exist, follow from Viete's formula to machine accuracy, whatever the speed.
        """
        head = np.asarray(speed, float) ** 2 / (2 * self.water.gravity)
        q, r = self.clearance + head, head * self.channel.depth**2
        ratio = 27 * r / (4 * q**3)  # reaches 1 where two roots merge
        angle = 2 / 3 * np.arcsin(np.sqrt(np.minimum(ratio, 1)))
        # Products of sines: sums of cosines would cancel where the clearance vanishes.
        upper = q / 3 * (1 + 2 * np.cos(angle))
        lower = 4 * q / 3 * np.sin(angle / 2) * np.sin(np.pi / 3 + angle / 2)
        below = -4 * q / 3 * np.sin(angle / 2) * np.sin(np.pi / 3 - angle / 2)
        below = np.where(ratio <= 1, below, self._single_root(q, ratio))
        # Far above the squat speed the pair is real again, but over the water line (u > H).
        real = np.where((ratio <= 1) & (2 * q <= 3 * self.channel.depth), 0.0, np.nan)
        h = self.clearance
        return Roots(upper - h + real, lower - h + real, below - h)

    @staticmethod
    def _single_root(q: Vector, ratio: Vector) -> Vector:
        """The one real root of the cubic where the other two are complex."""
        hyperbolic = np.arccosh(np.maximum(2 * ratio - 1, 1)) / 3
        return np.asarray(q / 3 * (1 - 2 * np.cosh(hyperbolic)))

    def squat_speed(self) -> Fold:
        """Speed at which both roots merge: P and P' vanish together.

        Stiffness vanishes at u^3 = V^2 H^2/g; the force there falls with V, and its sign change
        is bracketed to 1e-12 m/s by Brent's method.
        """
        H, h, g = self.channel.depth, self.clearance, self.water.gravity

        def sinkage(V: float) -> float:
            return math.cbrt((V * H) ** 2 / g) - h

        def force(V: float) -> float:
            return float(self.force(sinkage(V), V)) / (self.water.density * self.hull.length)

        bracket = 1e-6 * math.sqrt(g * h), math.sqrt(g * h**3) / H
        speed = float(brentq(force, *bracket, xtol=1e-13, rtol=4 * np.finfo(float).eps))
        half = 4e-13
        while not force(speed - half) > 0 > force(speed + half):
            half *= 2
        return Fold(speed, 2 * half, sinkage(speed))

    def period(self, w: ArrayLike, speed: ArrayLike, inertia: float) -> Vector:
        """Linear heave period [s] about `w` for m + m_add = `inertia` [kg/m]; NaN if unstable."""
        stiffness = self.stiffness(w, speed)
        stable = np.where(stiffness > 0, stiffness, np.nan)
        return np.asarray(2 * np.pi * np.sqrt(inertia / stable))
