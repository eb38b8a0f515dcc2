"""Task `limits`: one answer about a ship's safe speed, every number with its error.

All follow from the energies on three graded P2 meshes, extrapolated number by number.
"""

import math
from typing import Any, NamedTuple

import numpy as np
import xarray as xr

from squat.fluid.accuracy import Accuracy, Estimate
from squat.records import build
from squat.records.stability_kinds import LIMITS
from squat.stability.case import LimitsCase, Start
from squat.stability.dynamic import dynamic_squat_speed
from squat.stability.equilibria import Fold, OneDimensionalModel
from squat.stability.fold import squat_speed
from squat.stability.formulas import FORMULAS, Answer, Particulars
from squat.stability.heave import HeaveSystem
from squat.stability.local_depth import LocalDepthModel
from squat.stability.orbits import linear_period, orbit
from squat.stability.portrait import highest_pair
from squat.stability.sampling import estimate
from squat.stability.summary import summary
from squat.stability.validity import warnings

LIMIT_NAMES = ("1D", "2D", "dynamic")


class Numbers(NamedTuple):
    """What one mesh says, or an estimate of each: speeds [m/s], heave [m], periods [s]."""

    fold: Any
    sinkage: Any
    dynamic: Any
    equilibrium: Any
    linear_period: Any
    lowest: Any
    period: Any


def numbers(ship: HeaveSystem, start: Start, current: float) -> Numbers:
    """Limits, and the motion in `current` [m/s], of a ship on one mesh."""
    fold = squat_speed(ship.at_current)
    mode = ship.at_current(current)
    stable, _ = highest_pair(mode)
    linear = math.nan if math.isnan(stable) else linear_period(mode, stable)
    free = orbit(mode, start.heave, start.velocity)
    dynamic = dynamic_squat_speed(ship.at_current, fold, start.heave, start.velocity)
    return Numbers(fold.speed, fold.sinkage, dynamic, stable, linear, free.low, free.period)


def estimates(levels: list[HeaveSystem], start: Start, current: float, how: Accuracy) -> Numbers:
    """The same from all meshes: an `Estimate` each."""
    found = [numbers(level, start, current) for level in levels]
    return Numbers(*(estimate(list(values), how) for values in zip(*found, strict=True)))


def run(case: LimitsCase) -> xr.Dataset:
    """Dataset of kind `limits`, with the answer in words as its attribute `summary`."""
    levels = case.ship.levels(case.accuracy)
    case.start.check(levels[0].interval)
    found = estimates(levels, case.start, case.current, case.accuracy)
    one = OneDimensionalModel(case.hull, case.channel, case.water).squat_speed()
    local = LocalDepthModel(case.hull, case.channel, case.water).squat_speed()
    particulars = _particulars(case)
    answers = [formula.answer(particulars) for formula in FORMULAS]
    data = {
        **_motion(case, found, levels[0].interval.low / (case.grounding - 1)),
        **_limits(case, found, one),
        "limit_local": local.speed,
        **_formulas(answers),
    }
    data["warning"] = warnings(case, data)
    how = {"summary": summary(case, data), "free_surface": case.free_surface}
    return build(LIMITS, data, how)


def _particulars(case: LimitsCase) -> Particulars:
    outline = case.hull.outline
    block = outline.area / (outline.length * outline.draft)
    return Particulars(
        outline.length,
        outline.draft,
        block,
        case.channel.depth,
        case.current,
        case.water.gravity,
        case.beam,
        case.width,
    )


def _motion(case: LimitsCase, found: Numbers, clearance: float) -> dict[str, Any]:
    stable: Estimate = found.equilibrium
    head = math.sqrt(case.water.gravity * case.channel.depth)
    return {
        "current": case.current,
        "equilibrium": stable.value,
        "equilibrium_error": stable.error,
        "under_keel_clearance": clearance + stable.value,
        "least_clearance": clearance + found.lowest.value,
        "least_clearance_error": found.lowest.error,
        "period": found.period.value,
        "period_error": found.period.error,
        "linear_period": found.linear_period.value,
        "depth_froude_number": case.current / head,
    }


def _limits(case: LimitsCase, found: Numbers, one: Fold) -> dict[str, Any]:
    speeds = np.array([one.speed, found.fold.value, found.dynamic.value])
    return {
        "limit": list(LIMIT_NAMES),
        "limit_speed": speeds,
        "limit_error": np.array([one.width, found.fold.error, found.dynamic.error]),
        "limit_froude_number": speeds / math.sqrt(case.water.gravity * case.channel.depth),
    }


def _formulas(answers: list[Answer]) -> dict[str, Any]:
    return {
        "formula": [formula.name for formula in FORMULAS],
        "formula_squat": [answer.squat for answer in answers],
        "formula_limit": [answer.limit for answer in answers],
        "formula_note": [answer.note for answer in answers],
        "formula_source": [formula.source for formula in FORMULAS],
    }
