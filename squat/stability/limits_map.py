"""Task `limits_map`: the three limits of rectangles over H/T and L/T, run over the cores."""

import numpy as np
import xarray as xr

from squat.channel import Channel, Rectangle
from squat.cores import spread
from squat.records import build
from squat.records.stability_kinds import LIMITS_MAP
from squat.stability.case import LimitsMapCase
from squat.stability.sampled import Limits, Sampled
from squat.stability.sampling import Ship


def cell(case: LimitsMapCase, length_ratio: float, depth_ratio: float) -> Limits:
    """Limits of a rectangle with those L/T and H/T, set free at rest."""
    draft = case.draft
    length, depth = length_ratio * draft, depth_ratio * draft
    hull = Rectangle(length=length, draft=draft)
    channel = Channel(
        depth=depth, upstream=case.upstream * length, downstream=case.downstream * length
    )
    ship = Ship(hull, channel, case.water, case.free_surface, case.grounding)
    return Sampled(ship, case.accuracy).limits(case.start * draft, 0.0)


def run(case: LimitsMapCase) -> xr.Dataset:
    """Dataset of kind `limits_map`."""
    cells = [(a, b) for a in case.length_over_draft for b in case.depth_over_draft]
    found = spread(cell, ((case, *one) for one in cells), "limits")
    shape = len(case.length_over_draft), len(case.depth_over_draft)
    data = {
        "length_over_draft": list(case.length_over_draft),
        "depth_over_draft": list(case.depth_over_draft),
        **{
            name: np.array([getattr(one, name) for one in found]).reshape(shape)
            for name in Limits._fields
        },
    }
    return build(LIMITS_MAP, data, {"draft": case.draft, "start_over_draft": case.start})
