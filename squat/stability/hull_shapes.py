"""Task `hull_shapes`: hulls of different shape, of one draft and displacement, in one channel."""

from dataclasses import asdict, dataclass

import numpy as np
import xarray as xr

from squat.channel import AnyHull, resized, stretched
from squat.cores import spread
from squat.errors import InputError
from squat.fluid.accuracy import accurate
from squat.records import build
from squat.records.padding import padded
from squat.records.stability_kinds import HULL_SHAPES
from squat.stability import briefs
from squat.stability.case import HullShapesCase
from squat.stability.heave import HeaveSystem
from squat.stability.local_depth import LocalDepthModel
from squat.stability.orbits import linear_period
from squat.stability.portrait import highest_pair
from squat.stability.sampled import Sampled
from squat.stability.sampling import Ship


@dataclass(frozen=True)
class Shape:
    """One hull: its sizes and what follows, one number a variable of the record."""

    waterline_length: float
    length_overall: float
    area: float
    depth_of_keel: float
    block_coefficient: float
    added_mass_ratio: float
    added_mass_ratio_error: float
    fluid_mass_ratio: float
    limit_1d: float
    limit_local: float
    limit_2d: float
    limit_2d_error: float
    limit_dynamic: float
    limit_dynamic_error: float
    sinkage_1d: float
    sinkage_2d: float
    equilibrium: float
    equilibrium_error: float
    period: float
    period_error: float


def run(case: HullShapesCase) -> xr.Dataset:
    """Dataset of kind `hull_shapes`; InputError names the hull that it is about."""
    hulls = {name: alike(case, name) for name in case.hulls}
    shapes = spread(_named, ((case, name, hull) for name, hull in hulls.items()), "hulls")
    rows = [asdict(shape) for shape in shapes]
    outlines = [hull.outline.vertices for hull in hulls.values()]
    data = {
        "hull": list(hulls),
        **{name: [row[name] for row in rows] for name in rows[0]},
        "outline_x": padded([vertices[:, 0] for vertices in outlines]),
        "outline_z": padded([vertices[:, 1] for vertices in outlines]),
        "current": case.current,
        "start_heave": case.start.heave,
        "start_velocity": case.start.velocity,
    }
    how = {"free_surface": case.free_surface, "summary": briefs.hull_shapes(data)}
    return build(HULL_SHAPES, data, how)


def alike(case: HullShapesCase, name: str) -> AnyHull:
    """The hull of that name with the draft and submerged area of all."""
    try:
        hull = resized(case.hulls[name], draft=case.draft)
        return stretched(hull, case.displacement)
    except InputError as error:
        raise InputError(
            f"hulls.{name}: {error}; change hulls.{name}.KEY, or leave it out by '~hulls.{name}'"
        ) from error


def _named(case: HullShapesCase, name: str, hull: AnyHull) -> Shape:
    try:
        return shape(case, name, hull)
    except InputError as error:
        raise InputError(f"hulls.{name}: {error}") from error


def shape(case: HullShapesCase, name: str, hull: AnyHull) -> Shape:
    """All numbers of one hull; raises InputError where it floats nowhere or has no limit."""
    ship = Ship(hull, case.channel, case.water, case.free_surface, case.grounding, f"hulls.{name}")
    sampled = Sampled(ship, case.accuracy)
    finest = sampled.levels[-1]
    case.start.check(finest.interval)
    local = LocalDepthModel(hull, case.channel, case.water)
    return Shape(
        **_sizes(hull),
        **_masses(case, hull, finest),
        limit_local=local.squat_speed().speed,
        **sampled.limits(case.start.heave, case.start.velocity)._asdict(),
        **_motion(case, sampled),
    )


def _sizes(hull: AnyHull) -> dict[str, float]:
    outline = hull.outline
    return {
        "waterline_length": outline.length,
        "length_overall": float(np.ptp(outline.vertices[:, 0])),
        "area": outline.area,
        "depth_of_keel": outline.draft,
        "block_coefficient": outline.area / (outline.length * outline.draft),
    }


def _masses(case: HullShapesCase, hull: AnyHull, ship: HeaveSystem) -> dict[str, float]:
    """Eq. (23)'s added mass in heave, and the water's inertia in the runs, over the ship's mass."""
    found = accurate(hull, case.channel, case.accuracy, "zero_pressure")
    value, error = (float(part[1, 1]) / hull.outline.area for part in found)
    return {
        "added_mass_ratio": value,
        "added_mass_ratio_error": error,
        "fluid_mass_ratio": float(ship.inertia(0.0)) / ship.ship_mass,
    }


def _motion(case: HullShapesCase, sampled: Sampled) -> dict[str, float]:
    """Equilibrium in the common current, and the period in still water."""
    stable = [highest_pair(level.at_current(case.current))[0] for level in sampled.levels]
    periods = [linear_period(level, 0.0) for level in sampled.levels]
    equilibrium, period = sampled.estimate(stable), sampled.estimate(periods)
    return {
        "equilibrium": float(equilibrium.value),
        "equilibrium_error": float(equilibrium.error),
        "period": float(period.value),
        "period_error": float(period.error),
    }
