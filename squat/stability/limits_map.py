"""Task `limits_map`: the three limits of rectangles over H/T and L/T, run over the cores."""

from typing import NamedTuple

import numpy as np
import xarray as xr
from joblib import Parallel, delayed

from squat.channel import Channel, Rectangle
from squat.progress import progress
from squat.records import build
from squat.records.stability_kinds import LIMITS_MAP
from squat.stability.case import LimitsMapCase
from squat.stability.dynamic import dynamic_squat_speed
from squat.stability.equilibria import OneDimensionalModel
from squat.stability.fold import squat_speed
from squat.stability.sampling import Ship, estimate


class Cell(NamedTuple):
    """Limits [m/s] of one geometry, with errors, and the sinkages at the first two [m]."""

    limit_1d: float
    limit_2d: float
    limit_2d_error: float
    limit_dynamic: float
    limit_dynamic_error: float
    sinkage_1d: float
    sinkage_2d: float


def cell(case: LimitsMapCase, length_ratio: float, depth_ratio: float) -> Cell:
    """Limits of a rectangle with those L/T and H/T, set free at rest."""
    draft = case.draft
    length, depth = length_ratio * draft, depth_ratio * draft
    hull = Rectangle(length=length, draft=draft)
    channel = Channel(
        depth=depth, upstream=case.upstream * length, downstream=case.downstream * length
    )
    one = OneDimensionalModel(hull, channel, case.water).squat_speed()
    levels = Ship(hull, channel, case.water, case.free_surface, case.grounding).levels(
        case.accuracy
    )
    folds = [squat_speed(level.at_current) for level in levels]
    start = case.start * draft
    dynamic = [
        dynamic_squat_speed(level.at_current, fold, start, 0.0)
        for level, fold in zip(levels, folds, strict=True)
    ]
    speed = estimate([fold.speed for fold in folds], case.accuracy)
    lost = estimate(dynamic, case.accuracy)
    values = one.speed, *speed, *lost, one.sinkage, folds[-1].sinkage
    return Cell(*(float(value) for value in values))


def run(case: LimitsMapCase) -> xr.Dataset:
    """Dataset of kind `limits_map`."""
    cells = [(a, b) for a in case.length_over_draft for b in case.depth_over_draft]
    jobs = (delayed(cell)(case, *one) for one in cells)
    results = Parallel(n_jobs=-1, return_as="generator")(jobs)
    found = list(progress(results, total=len(cells), label="limits"))
    shape = len(case.length_over_draft), len(case.depth_over_draft)
    data = {
        "length_over_draft": list(case.length_over_draft),
        "depth_over_draft": list(case.depth_over_draft),
        **{
            name: np.array([getattr(one, name) for one in found]).reshape(shape)
            for name in Cell._fields
        },
    }
    return build(LIMITS_MAP, data, {"draft": case.draft, "start_over_draft": case.start})
