"""Ready-made hull sections: one class a shape, chosen by `hull=<shape>`."""

import math
from typing import Literal

import numpy as np
from pydantic.dataclasses import dataclass

from squat.channel.hull import Hull, Segments, arc, half_turn
from squat.errors import InputError
from squat.quantities import STRICT, Fraction, Length, Vector


def swelled(chain: Vector) -> Vector:
    """Points (n, 2) of a smooth curve moved out of it, so that their chords enclose what it does.

    Chords stray by s = |p''| dt^2/8 to one side, by 2/3 of that in the mean: so far goes a point,
    as (p_i - (p_{i-1} + p_{i+1})/2)/6, but not beyond the ends and the lowest point, by which the
    section has its length and draft.
    """
    moved = chain.copy()
    moved[1:-1] += (chain[1:-1] - (chain[:-2] + chain[2:]) / 2) / 6
    return np.clip(moved, chain.min(axis=0), chain.max(axis=0))


@dataclass(frozen=True, kw_only=True, config=STRICT)
class Rectangle(Hull):
    """The paper's box (Fig. 8)."""

    shape: Literal["rectangle"] = "rectangle"

    def section(self) -> Vector:
        """See `Hull.section`."""
        L, T = self.length, self.draft
        return np.array([(0, 0), (0, -T), (L, -T), (L, 0)], float)


@dataclass(frozen=True, kw_only=True, config=STRICT)
class WalledHull(Hull):
    """A section below vertical walls.

    Parameters
    ----------
    wall
        Height [m] of the vertical sides between the still water line and the sloped or curved
        part; it bounds upward motion and cannot be zero, since the walls immerse as the ship sinks.
    """

    wall: Length

    def __post_init__(self) -> None:
        if self.wall >= self.draft:
            raise InputError(
                f"hull.wall={self.wall:g}: must be less than hull.draft={self.draft:g}"
            )

    @property
    def depth(self) -> float:
        """Height [m] of the part below the walls."""
        return self.draft - self.wall

    def below(self, lower: Vector) -> Vector:
        """The chain of `lower`, given from the foot of one wall to that of the other."""
        return np.concatenate([[(0.0, 0.0)], lower - [0, self.wall], [(self.length, 0.0)]])


@dataclass(frozen=True, kw_only=True, config=STRICT)
class HalfEllipse(WalledHull):
    """x = L/2 (1 + cos t), z = -wall + (T - wall) sin t, `swelled`; `segments` chords, even."""

    shape: Literal["half_ellipse"] = "half_ellipse"
    segments: Segments

    def __post_init__(self) -> None:
        super().__post_init__()
        _even(self.segments)

    def section(self) -> Vector:
        """See `Hull.section`."""
        t = half_turn(self.segments)
        ellipse = [self.length / 2 * (1 + np.cos(t)), self.depth * np.sin(t)]
        return self.below(swelled(np.stack(ellipse, axis=1)))


@dataclass(frozen=True, kw_only=True, config=STRICT)
class Vee(WalledHull):
    """Two straight lines that meet at the keel, amidships."""

    shape: Literal["v"] = "v"

    def section(self) -> Vector:
        """See `Hull.section`."""
        keel = (self.length / 2, -self.depth)
        return self.below(np.array([(0, 0), keel, (self.length, 0)], float))


@dataclass(frozen=True, kw_only=True, config=STRICT)
class ChamferedBox(Hull):
    """Rectangle with corners cut at 45 degrees; `chamfer` [m] is the cut's height and width."""

    shape: Literal["chamfered_box"] = "chamfered_box"
    chamfer: Length

    def __post_init__(self) -> None:
        _fits("chamfer", self.chamfer, self)

    def section(self) -> Vector:
        """See `Hull.section`."""
        L, T, c = self.length, self.draft, self.chamfer
        return np.array([(0, 0), (0, c - T), (c, -T), (L - c, -T), (L, c - T), (L, 0)], float)


@dataclass(frozen=True, kw_only=True, config=STRICT)
class RoundedBox(Hull):
    """Rectangle with corners of `radius` [m], each of `segments` chords."""

    shape: Literal["rounded_box"] = "rounded_box"
    radius: Length
    segments: Segments

    def __post_init__(self) -> None:
        _fits("radius", self.radius, self)

    def section(self) -> Vector:
        """See `Hull.section`."""
        L, T, r, n = self.length, self.draft, self.radius, self.segments
        bow = arc((r, r - T), r, math.pi, 1.5 * math.pi, n)
        stern = arc((L - r, r - T), r, 1.5 * math.pi, 2 * math.pi, n)
        return np.concatenate([[(0.0, 0.0)], swelled(bow), swelled(stern), [(L, 0.0)]])


@dataclass(frozen=True, kw_only=True, config=STRICT)
class Lewis(WalledHull):
    """Lewis form: the image of the unit circle under M (e^(i t) + a1 e^(-i t) + a3 e^(-3 i t)).

    x = M ((1 + a1) sin t - a3 sin 3t), depth = M ((1 - a1) cos t + a3 cos 3t), with a1, a3, M from
    length, depth below the walls and area coefficient (Lewis 1929; von Kerczek and Tuck 1969).

    Parameters
    ----------
    area_coefficient
        Area below the walls over that of its bounding box, within `fullness`.
    segments
        Chords of the polygon, an even number, whose corners are `swelled`.
    """

    shape: Literal["lewis"] = "lewis"
    area_coefficient: Fraction
    segments: Segments

    def __post_init__(self) -> None:
        super().__post_init__()
        _even(self.segments)
        least, greatest = self.fullness
        if not least <= self.area_coefficient <= greatest:
            raise InputError(
                f"hull.area_coefficient={self.area_coefficient:g}: must be within "
                f"{math.ceil(1e4 * least) / 1e4:g} and {math.floor(1e4 * greatest) / 1e4:g} "
                f"for a Lewis form {self.length:g} m long and {self.depth:g} m deep below its walls"
            )

    def section(self) -> Vector:
        """See `Hull.section`."""
        a1, a3 = self.coefficients()
        M = self.length / 2 / (1 + a1 + a3)
        t = half_turn(self.segments) - 1.5 * math.pi  # 0 at the keel
        x = M * ((1 + a1) * np.sin(t) - a3 * np.sin(3 * t))
        depth = M * ((1 - a1) * np.cos(t) + a3 * np.cos(3 * t))
        return self.below(swelled(np.stack([x + self.length / 2, -depth], axis=1)))

    def coefficients(self) -> tuple[float, float]:
        """a1 and a3."""
        fill = 4 * self.area_coefficient / math.pi
        c = 3 + fill + (1 - fill) * self._skew**2
        a3 = (3 - c + math.sqrt(9 - 2 * c)) / c
        return self._skew * (1 + a3), a3

    @property
    def fullness(self) -> tuple[float, float]:
        """Least and greatest area coefficient of a form within its box, monotone along each side.

        With u = cos t, depth = M ((1 - a1 - 3 a3) u + 4 a3 u^3) grows from water line to keel where
        its derivative is positive at both: -(1 - a1)/9 <= a3 <= (1 - a1)/3. Below that the keel is
        hollow and its flanks deeper than the draft; above it the sides rise over the walls' feet.
        The same of x has 1 + a1 for 1 - a1. The area coefficient falls as a3 grows.
        """
        skew = abs(self._skew)
        return self._filled((1 - skew) / (3 + skew)), self._filled(-(1 - skew) / (9 - skew))

    @property
    def _skew(self) -> float:
        """a1 / (1 + a3)."""
        ratio = self.length / 2 / self.depth
        return (ratio - 1) / (ratio + 1)

    def _filled(self, a3: float) -> float:
        """Area coefficient that goes with `a3`."""
        a1 = self._skew * (1 + a3)
        return math.pi / 4 * (1 - a1**2 - 3 * a3**2) / ((1 + a3) ** 2 - a1**2)


def _even(segments: int) -> None:
    """InputError unless two of the chords meet at the keel, as deep as the draft."""
    if segments % 2:
        raise InputError(f"hull.segments={segments}: must be even here; give {segments + 1}")


def _fits(key: str, size: float, hull: Hull) -> None:
    limit = min(hull.draft, hull.length / 2)
    if size >= limit:
        raise InputError(
            f"hull.{key}={size:g}: must be less than draft and half the length, {limit:g}"
        )
