"""What the tasks `stability`, `limits`, `limits_map` and `hull_shapes` are asked."""

from typing import Annotated

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
    Velocity,
)
from squat.stability.one_mode import Interval
from squat.stability.run import Speeds
from squat.stability.sampling import Ship, Surface
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
    """Evenly spaced values, `points` from `least` to `greatest`."""

    least: Position
    greatest: Position
    points: Annotated[int, Field(strict=True, ge=2, le=1000)]

    def __post_init__(self) -> None:
        if self.greatest <= self.least:
            raise InputError(f"greatest={self.greatest:g}: must exceed least={self.least:g}")


@dataclass(frozen=True, kw_only=True, config=STRICT)
class Portrait:
    """Points of the curves.

    Parameters
    ----------
    heave_points, loop_points
        Of U(w), and of each half of the separatrix.
    heaves, velocities
        w(0) [m] and w'(0) [m/s] of the map of dynamic limits.
    """

    heave_points: Count
    loop_points: Count
    heaves: Range
    velocities: Range


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
