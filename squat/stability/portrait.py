"""Task `stability`: one ship on one mesh, from its energies to its dataset."""

import math

import numpy as np
import xarray as xr

from squat.quantities import Vector
from squat.records import build
from squat.records.stability_kinds import STABILITY
from squat.stability import briefs
from squat.stability.branches import equilibria
from squat.stability.case import StabilityCase
from squat.stability.dynamic import dynamic_squat_speed
from squat.stability.equilibria import Fold, OneDimensionalModel
from squat.stability.fold import squat_speed
from squat.stability.heave import HeaveSystem
from squat.stability.one_mode import OneMode
from squat.stability.orbits import linear_period, orbit
from squat.stability.separatrix import separatrix, well


def run(case: StabilityCase) -> xr.Dataset:
    """Dataset of kind `stability`."""
    ship = case.ship.on(case.mesh)
    case.start.check(ship.interval)
    fold = squat_speed(ship.at_current)
    one = OneDimensionalModel(case.hull, case.channel, case.water)
    one_fold = one.squat_speed()
    start = case.start
    data = {
        **_over_speed(case, ship, one, fold),
        **_portraits(case, ship, fold),
        **_map(case, ship, fold),
        "start_heave": start.heave,
        "start_velocity": start.velocity,
        "squat_speed_1d": one_fold.speed,
        "squat_sinkage_1d": one_fold.sinkage,
        "squat_speed_2d": fold.speed,
        "squat_sinkage_2d": fold.sinkage,
        "dynamic_squat_speed": dynamic_squat_speed(
            ship.at_current, fold, start.heave, start.velocity
        ),
        "ship_mass": ship.ship_mass,
    }
    how = {
        "free_surface": case.free_surface,
        "squat_speed_bracket": fold.width,
        "summary": briefs.stability(data),
    }
    return build(STABILITY, data, how)


def highest_pair(mode: OneMode) -> tuple[float, float]:
    """The highest stable equilibrium and the unstable one below it [m]; NaN where there is none."""
    found = equilibria(mode)
    stable = [one.heave for one in found if one.stable]
    if not stable:
        return math.nan, math.nan
    below = [one.heave for one in found if not one.stable and one.heave < stable[-1]]
    return stable[-1], below[-1] if below else math.nan


def _over_speed(
    case: StabilityCase, ship: HeaveSystem, one: OneDimensionalModel, fold: Fold
) -> dict[str, Vector]:
    speed = case.speeds.curve(fold.speed)
    rows = []
    for V in speed:
        mode = ship.at_current(float(V))
        stable, unstable = highest_pair(mode)
        linear = math.nan if math.isnan(stable) else linear_period(mode, stable)
        free = orbit(mode, case.start.heave, case.start.velocity)
        rows.append((stable, unstable, linear, free.period, free.low, free.high))
    names = ("stable", "unstable", "linear_period", "period", "lowest", "highest")
    roots = one.roots(speed)
    return {
        "speed": speed,
        **dict(zip(names, np.array(rows).T, strict=True)),
        "stable_1d": roots.stable,
        "unstable_1d": roots.unstable,
    }


def _portraits(case: StabilityCase, ship: HeaveSystem, fold: Fold) -> dict[str, Vector]:
    speeds = case.speeds.single(fold.speed)
    modes = [ship.at_current(V) for V in speeds.tolist()]
    heave = ship.interval.grid(case.portrait.heave_points)
    loops = [separatrix(mode, case.portrait.loop_points) for mode in modes]
    wells = np.array([well(mode) for mode in modes])
    return {
        "case_speed": speeds,
        "case_stable": wells[:, 1],
        "case_unstable": wells[:, 0],
        "case_action": np.array([loop.area for loop in loops]),
        "heave": heave,
        "inertia": ship.mass(heave),
        "potential": np.array([mode.potential(heave) for mode in modes]),
        "separatrix_heave": np.array([loop.heave for loop in loops]),
        "separatrix_velocity": np.array([loop.velocity for loop in loops]),
    }


def _map(case: StabilityCase, ship: HeaveSystem, fold: Fold) -> dict[str, Vector]:
    heaves, velocities = case.portrait.starts(ship.interval, linear_period(ship, 0.0))
    inside = (heaves > ship.interval.low) & (heaves < ship.interval.high)
    limits = np.full((len(heaves), len(velocities)), math.nan)
    for i in np.flatnonzero(inside):
        for j, velocity in enumerate(velocities):
            start = float(heaves[i]), float(velocity)
            limits[i, j] = dynamic_squat_speed(ship.at_current, fold, *start)
    return {"initial_heave": heaves, "initial_velocity": velocities, "limit_map": limits}
