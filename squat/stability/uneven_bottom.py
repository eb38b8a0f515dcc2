"""Task `uneven_bottom`: a held ship over a shelf, against Eq. (27) with the depth found there.

The bottom rises by a straight ramp to a shelf ahead of the bow, and the ramp is put at one place
after another, from ahead of the ship to astern of it. The current is that of Out, over z = 0.
"""

from collections.abc import Callable
from dataclasses import replace
from typing import Annotated, Any, NamedTuple

import numpy as np
import xarray as xr
from pydantic import Field
from pydantic.dataclasses import dataclass

from squat.channel import AnyHull, Channel, Rectangle
from squat.cores import spread
from squat.errors import InputError
from squat.fluid.accuracy import LEVELS, Accuracy, Estimate, extrapolate
from squat.fluid.direct import DirectEnergies
from squat.fluid.energy import ShipEnergy, still_water
from squat.fluid.ship import about_gravity, rigid_body
from squat.mesh import submesh
from squat.mesh.generate import generate
from squat.quantities import STRICT, Fraction, Position, Positive, Speed, Vector
from squat.records import build
from squat.records.bottom_kinds import UNEVEN_BOTTOM
from squat.stability import briefs
from squat.stability.fold import squat_speed
from squat.stability.local_depth import LocalDepthModel
from squat.stability.sampling import Ship, estimate
from squat.water import Water

MODES = ("heave", "pitch")


@dataclass(frozen=True, kw_only=True, config=STRICT)
class UnevenBottomCase:
    """A ship over a shelf, held at rest.

    Parameters
    ----------
    channel
        With a flat bottom; the ramp is laid by the task.
    current
        V at Out [m/s].
    grounding
        Clearance over that at rest, below which the ship counts as grounded.
    rise
        Height of the shelf [m].
    steepness
        Rise of the ramp over its length.
    places
        Middle of the ramp [m], x from the bow: below 0 ahead of the ship.
    gaps
        Clearances over the ship's length, of a ship over the middle of a ramp half as long.
    rise_over_gap
        Rise of that ramp over the clearance at its foot.
    rises
        Heights of the shelf [m] whose squat speed is sought, the ramp's middle under mid-length.
    rises_steepness
        Rise of these ramps over their lengths.
    """

    hull: AnyHull
    channel: Channel
    water: Water
    accuracy: Accuracy
    current: Speed
    grounding: Fraction
    rise: Positive
    steepness: Annotated[tuple[Positive, ...], Field(min_length=1)]
    places: Annotated[tuple[Position, ...], Field(min_length=1)]
    gaps: Annotated[tuple[Positive, ...], Field(min_length=1)]
    rise_over_gap: Annotated[float, Field(gt=0, lt=1)]
    rises: Annotated[tuple[Annotated[float, Field(ge=0, le=1e5)], ...], Field(min_length=1)]
    rises_steepness: Positive

    def __post_init__(self) -> None:
        if self.channel.bottom:
            raise InputError("channel.bottom: the task lays a ramp of its own; leave it empty")

    def over(self, rise: float, steepness: float, place: float) -> LocalDepthModel:
        """The ship, in one dimension, with the ramp's middle at `place`."""
        return LocalDepthModel(self.hull, ramp(self.channel, rise, steepness, place), self.water)

    def slender(self, gap: float) -> LocalDepthModel:
        """The ship at a clearance of `gap` lengths, over a ramp of half its length."""
        length = self.hull.length
        rise = self.rise_over_gap * gap * length
        flat = replace(self.channel, depth=self.hull.draft + gap * length)
        return LocalDepthModel(
            self.hull, ramp(flat, rise, 2 * rise / length, length / 2), self.water
        )


def ramp(channel: Channel, rise: float, steepness: float, place: float) -> Channel:
    """`channel` with a bottom that is `rise` high ahead of a ramp and level behind it."""
    half = rise / steepness / 2
    points = ((place - half, rise), (place + half, 0.0)) if rise else ()
    return replace(channel, bottom=points)


class Loads(NamedTuple):
    """Force [N/m] and moment [N], shape (2,) each: in two dimensions, 1D and 1D complete."""

    flow: Estimate
    local: Vector
    complete: Vector


def loads(model: LocalDepthModel, accuracy: Accuracy, current: float) -> Loads:
    """Steady heave force and pitch moment of a ship at rest, from three meshes and in 1D."""
    found = [_steady(model, accuracy, level, current) for level in range(LEVELS)]
    flow = extrapolate(found, float(accuracy.refinement), accuracy.safety)
    complete = _complete(model)
    one, two = (
        current**2 * np.array([m.force(0.0), m.moment(0.0)]) if m else np.full(2, np.nan)
        for m in (model, complete)
    )
    return Loads(flow, one, two)


def _steady(model: LocalDepthModel, accuracy: Accuracy, level: int, current: float) -> Vector:
    """V^2 a'/2 - dU_B/dq on one mesh, shape (2,): what the current alone does."""
    hull, channel, water = model.hull, model.channel, model.water
    size = accuracy.size(hull, channel, level)
    mesh = about_gravity(generate(submesh(hull, channel, MODES), size), hull)
    still = still_water(mesh.submesh, water)
    energies = DirectEnergies(mesh, water, "rigid_lid")
    ship = ShipEnergy(rigid_body(hull, water, MODES), still, energies, current)
    rest = np.zeros(len(MODES))
    return ship.at_current(0.0).gradient(rest) - ship.gradient(rest)


def _complete(model: LocalDepthModel) -> LocalDepthModel | None:
    return replace(model, complete=True) if isinstance(model.hull, Rectangle) else None


class Limit(NamedTuple):
    """Squat speed [m/s] with error and sinkage [m], and what both 1D models say."""

    speed: float
    error: float
    sinkage: float
    local: float
    local_sinkage: float
    complete: float


def limit(model: LocalDepthModel, accuracy: Accuracy, grounding: float) -> Limit:
    """Squat speed in heave of a ship kept level."""
    ship = Ship(model.hull, model.channel, model.water, "rigid_lid", grounding)
    folds = [squat_speed(level.at_current) for level in ship.levels(accuracy)]
    speed = estimate([fold.speed for fold in folds], accuracy)
    local, complete = model.squat_speed(), _complete(model)
    return Limit(
        float(speed.value),
        float(speed.error),
        folds[-1].sinkage,
        local.speed,
        local.sinkage,
        complete.squat_speed().speed if complete else np.nan,
    )


def run(case: UnevenBottomCase) -> xr.Dataset:
    """Dataset of kind `uneven_bottom`."""
    ramps = [case.over(case.rise, s, x) for s in case.steepness for x in case.places]
    slender = [case.slender(gap) for gap in case.gaps]
    places = ((model, case.accuracy, case.current) for model in [*ramps, *slender])
    found = spread(loads, places, "loads")
    shelves = [case.over(r, case.rises_steepness, case.hull.length / 2) for r in case.rises]
    limits = spread(limit, ((model, case.accuracy, case.grounding) for model in shelves), "limits")
    shape = len(case.steepness), len(case.places)
    data = {
        "steepness": list(case.steepness),
        "place": list(case.places),
        "gap_over_length": list(case.gaps),
        "rise": list(case.rises),
        **_columns("", found[: len(ramps)], shape),
        **_columns("slender_", found[len(ramps) :], (len(slender),)),
        **{
            name: np.array([getattr(one, field) for one in limits])
            for name, field in zip(_LIMITS, Limit._fields, strict=True)
        },
        "length": case.hull.length,
        "clearance": case.channel.depth - case.hull.draft,
        "shelf_rise": case.rise,
        "current": case.current,
    }
    return build(UNEVEN_BOTTOM, data, {"summary": briefs.uneven_bottom(data)})


_LIMITS = (
    "squat_speed",
    "squat_speed_error",
    "squat_sinkage",
    "squat_speed_1d",
    "squat_sinkage_1d",
    "squat_speed_complete",
)


def _columns(prefix: str, found: list[Loads], shape: tuple[int, ...]) -> dict[str, Any]:
    """Force and moment of many places as arrays of `shape`."""
    return {
        f"{prefix}{name}{suffix}": np.array([take(one)[i] for one in found]).reshape(shape)
        for i, name in enumerate(("force", "moment"))
        for suffix, take in _PARTS.items()
    }


_PARTS: dict[str, Callable[[Loads], Vector]] = {
    "": lambda one: one.flow.value,
    "_error": lambda one: one.flow.error,
    "_1d": lambda one: one.local,
    "_complete": lambda one: one.complete,
}
