"""The ship in its channel: lines from the record, the field from its snapshots."""

from typing import NamedTuple

import numpy as np
import rerun as rr
import rerun.blueprint as rrb
from pydantic import TypeAdapter

from squat.channel import AnyHull, Channel
from squat.quantities import Vector
from squat.replay import scene
from squat.replay.field import Scales, draw_field, snapshot_times
from squat.replay.moved import moved
from squat.replay.panels import Place, panel, picture_aspect
from squat.replay.recorder import Recorder, entity
from squat.replay.runs import Run
from squat.replay.style import GREY, PALE, SKY

_FREEBOARD = 0.3  # of the draft: how far the walls are drawn above the water
_BELOW, _ABOVE, _BESIDE = 0.75, 0.3, 0.03  # margins of the picture, of depth and of length
_ASPECT = 3.0  # of the pictures' place in the layout, which they share
_LONGEST = 8.0  # width over height of a channel in equal scales, about, as in the figures


class Extent(NamedTuple):
    """The channel's ends and levels [m], its bed, and the hull's chain at rest (n, 2)."""

    inlet: float
    outlet: float
    depth: float
    bed: Vector
    hull: Vector

    @classmethod
    def of(cls, run: Run) -> "Extent":
        """From the configuration of a run."""
        hull = TypeAdapter(AnyHull).validate_python(run.config["hull"])
        channel = TypeAdapter(Channel).validate_python(run.config["channel"])
        bed, chain = channel.bed(hull.length), hull.outline.vertices + np.array([0, channel.depth])
        return cls(float(bed[0, 0]), float(bed[-1, 0]), channel.depth, bed, chain)

    @property
    def length(self) -> float:
        """Distance of In and Out [m]."""
        return self.outlet - self.inlet

    @property
    def stretch(self) -> int:
        """How many times heights are stretched in the picture of a long, shallow channel."""
        return max(1, round(self.length / self.depth / _LONGEST))


@panel("channel", Place.PICTURE, ("heave",))
def channel(recorder: Recorder, runs: tuple[Run, ...]) -> list[rrb.View]:
    """One picture a run, all in the same scales."""
    scales = Scales.of(runs)
    times = max(Extent.of(run).stretch for run in runs)
    aspect = picture_aspect(_ASPECT, len(runs))
    return [_picture(recorder, run, scales, times, aspect) for run in runs]


def _picture(
    recorder: Recorder, run: Run, scales: Scales | None, times: int, aspect: float
) -> rrb.View:
    extent = Extent.of(run)
    origin = entity(run, "channel")
    if times > 1:
        recorder.static(origin, rr.Transform3D.columns(scale=[[1.0, 1.0, times]]))
    _still_lines(recorder, origin, extent)
    _hull(recorder, origin, run, extent)
    low = np.array([extent.inlet - _BESIDE * extent.length, extent.bed[:, 1].min()])
    high = np.array([extent.outlet + _BESIDE * extent.length, extent.depth])
    low[1] -= _BELOW * extent.depth
    high[1] += _ABOVE * extent.depth
    stretched = np.array([1, times])
    low, high = low * stretched, high * stretched
    if run.fields is not None and scales is not None:
        middle, seen = (low + high)[0] / 2, scene.seen_width(low, high, aspect)
        draw_field(recorder, origin, run, (middle - seen / 2, middle + seen / 2), scales)
    what = "Channel"
    if run.fields is not None:
        count = run.fields.sizes["time"]
        what += f" at {count} snapshot{'s' * (count > 1)}: pressure less hydrostatic, velocity"
    if times > 1:
        what += f", heights × {times}"
    return scene.section_view(f"/{origin}", run.told(what), low, high, aspect, times > 1)


def _still_lines(recorder: Recorder, origin: str, extent: Extent) -> None:
    """Bottom, and the water line on both sides of the hull."""
    layer = scene.raised(extent.length)
    scene.lines(recorder, f"{origin}/bottom", [scene.placed(extent.bed, layer)], GREY, 3)
    ends = [(extent.inlet, extent.hull[0, 0]), (extent.hull[-1, 0], extent.outlet)]
    water = [np.array([(x, extent.depth) for x in side]) for side in ends]
    strips = [scene.placed(line, layer) for line in water]
    scene.lines(recorder, f"{origin}/water_line", strips, SKY, 2)


def _hull(recorder: Recorder, origin: str, run: Run, extent: Extent) -> None:
    """Closed outline that moves and turns; with the snapshots where there are some."""
    times = run.steps.time if run.fields is None else snapshot_times(run.fields)
    top = extent.depth + _FREEBOARD * (extent.depth - extent.hull[:, 1].min())
    deck = [(extent.hull[-1, 0], top), (extent.hull[0, 0], top), tuple(extent.hull[0])]
    outline = moved(run, np.concatenate([extent.hull, deck]), times)
    strips = scene.placed(outline, scene.raised(extent.length))
    path = f"{origin}/hull"
    recorder.static(path, scene.look(PALE, 2.5))
    recorder.rows(path, run.clock(times), rr.LineStrips3D.columns(strips=list(strips)))
