"""What the tasks `stability`, `limits`, `limits_map` and `hull_shapes` are asked."""

import math
from typing import Annotated

import numpy as np
from pydantic import Field
from pydantic.dataclasses import dataclass

from squat.channel import AnyHull, Channel
from squat.errors import InputError
from squat.fluid.accuracy import Accuracy
from squat.mesh import MeshSize
from squat.quantities import (
    STRICT,
    Area,
    Count,
    Fraction,
    Length,
    Position,
    Positive,
    Speed,
    Vector,
    Velocity,
)
from squat.stability.one_mode import Interval
from squat.stability.sampling import Ship, Surface
from squat.stability.speeds import Speeds, readable
from squat.water import Water


@dataclass(frozen=True, kw_only=True, config=STRICT)
class Start:
    """How the ship is set free.

    Parameters
    ----------
    heave
        w(0) [m].
    velocity
        w'(0) [m/s].
    """

    heave: Position
    velocity: Velocity

    def check(self, interval: Interval) -> None:
        """Raise InputError where the ship cannot start there."""
        if not interval.low < self.heave < interval.high:
            raise InputError(
                f"start.heave={self.heave:g}: must be between grounding at {interval.low:.4g} "
                f"and {interval.high:.4g} m"
            )


@dataclass(frozen=True, kw_only=True, config=STRICT)
class Range:
    """Evenly spaced values, `points` from `least` to `greatest`; None: the ship's own."""

    least: Position | None
    greatest: Position | None
    points: Annotated[int, Field(strict=True, ge=2, le=1000)]

    def values(self, key: str, least: float, greatest: float) -> Vector:
        """The values of `key`, shape (points,), between the ship's own ends where none are given.

        Raises InputError where the least is not below the greatest.
        """
        low = least if self.least is None else self.least
        high = greatest if self.greatest is None else self.greatest
        check_order(key, low, high)
        return np.linspace(low, high, self.points)


def check_order(key: str, least: float | None, greatest: float | None) -> None:
    """Raise InputError where both ends of the range `key` are given, in the wrong order."""
    if least is not None and greatest is not None and greatest <= least:
        raise InputError(f"{key}.greatest={greatest:g}: must exceed {key}.least={least:g}")


@dataclass(frozen=True, kw_only=True, config=STRICT)
class Portrait:
    """Points of the curves.

    Parameters
    ----------
    heave_points, loop_points
        Of U(w), and of each half of the separatrix.
    heaves, velocities
        w(0) [m] and w'(0) [m/s] of the map of dynamic limits.
    heave_shares
        Ends of `heaves` where they are not given, over those of the interval of heave.
    velocity_share
        Greatest of `velocities` where it is not given, over that of a small heave in still water
        as wide as grounding is deep.
    """

    heave_points: Count
    loop_points: Count
    heaves: Range
    velocities: Range
    heave_shares: tuple[Positive, Positive]
    velocity_share: Positive

    def __post_init__(self) -> None:
        for name in ("heaves", "velocities"):
            ends = getattr(self, name)
            check_order(f"portrait.{name}", ends.least, ends.greatest)

    def starts(self, interval: Interval, period: float) -> tuple[Vector, Vector]:
        """Heaves [m] and velocities [m/s] of the map, of a ship of that small-heave `period`."""
        deep, high = (
            readable(share * end, abs(end))
            for share, end in zip(self.heave_shares, (interval.low, interval.high), strict=True)
        )
        speed = 2 * math.pi / period * abs(interval.low)
        fastest = readable(self.velocity_share * speed, speed)
        return (
            self.heaves.values("portrait.heaves", deep, high),
            self.velocities.values("portrait.velocities", 0.0, fastest),
        )


@dataclass(frozen=True, kw_only=True, config=STRICT)
class _Floating:
    """A ship in a channel, and how it is set free.

    Parameters
    ----------
    grounding
        Clearance over that at rest, below which the ship counts as grounded.
    """

    hull: AnyHull
    channel: Channel
    water: Water
    free_surface: Surface
    grounding: Fraction
    start: Start

    @property
    def ship(self) -> Ship:
        """What the energies depend on."""
        return Ship(self.hull, self.channel, self.water, self.free_surface, self.grounding)


@dataclass(frozen=True, kw_only=True, config=STRICT)
class StabilityCase(_Floating):
    """A ship on the mesh of its coupled runs: limits and portrait of just that system."""

    mesh: MeshSize
    speeds: Speeds
    portrait: Portrait


@dataclass(frozen=True, kw_only=True, config=STRICT)
class LimitsCase(_Floating):
    """A ship about whose safe speed a hydrodynamicist asks.

    Parameters
    ----------
    current
        Speed through the water [m/s].
    accuracy
        Meshes of the extrapolated values.
    beam, width
        Beam of the ship and width of the channel [m], for the usual formulas only, which are for
        ships in three dimensions. Without them the ship fills the channel's width.
    """

    current: Speed
    accuracy: Accuracy
    beam: Length | None
    width: Length | None

    def __post_init__(self) -> None:
        if self.beam is None and self.width is not None:
            raise InputError(f"width={self.width:g}: means nothing without beam=; give both")
        if self.beam is not None and self.width is not None and self.width < self.beam:
            raise InputError(f"width={self.width:g}: must be at least beam={self.beam:g}")


@dataclass(frozen=True, kw_only=True, config=STRICT)
class LimitsMapCase:
    """Rectangles over H/T and L/T, In and Out in proportion to L.

    Parameters
    ----------
    draft
        T [m]; speeds scale with its square root.
    upstream, downstream
        Distances of In and Out over L.
    start
        w(0)/T of a ship at rest.
    """

    water: Water
    accuracy: Accuracy
    free_surface: Surface
    grounding: Fraction
    draft: Length
    depth_over_draft: Annotated[tuple[Annotated[float, Field(gt=1)], ...], Field(min_length=1)]
    length_over_draft: Annotated[tuple[Positive, ...], Field(min_length=1)]
    upstream: Positive
    downstream: Positive
    start: Annotated[float, Field(gt=-0.5, lt=0.5)]


@dataclass(frozen=True, kw_only=True, config=STRICT)
class HullShapesCase:
    """Hulls that differ in shape alone: of one draft and one submerged area, in one channel.

    Parameters
    ----------
    hulls
        By name; each is given `draft` and stretched to `displacement`.
    draft
        T of all [m].
    displacement
        Submerged area of all [m2].
    current
        V [m/s] at which their sinkages are compared.
    """

    hulls: Annotated[dict[str, AnyHull], Field(min_length=1)]
    channel: Channel
    water: Water
    accuracy: Accuracy
    free_surface: Surface
    grounding: Fraction
    start: Start
    draft: Length
    displacement: Area
    current: Speed
