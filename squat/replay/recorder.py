"""The one way into a recording: columns over both time axes."""

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from typing import Any

import numpy as np
import rerun as rr

from squat.progress import progress
from squat.quantities import Vector
from squat.replay.runs import Clock, Run
from squat.replay.style import rgba

_DOT, _DOTS = 4.0, 2.0  # size of the only point of a curve, and of one of many, points
_BATCH = 16  # frames in a chunk: some megabyte of mesh, which the viewer loads and drops at once


def entity(run: Run | None, *parts: str) -> str:
    """Path of an entity of `run`; below its label where there are several runs."""
    label = [run.label] if run is not None and run.label else []
    return "/".join(rr.escape_entity_path_part(part) for part in (*label, *parts))


@dataclass(frozen=True)
class Recorder:
    """Columns of a recording."""

    stream: rr.RecordingStream

    def static(self, path: str, columns: Iterable[Any]) -> None:
        """Data that holds at all times."""
        self.stream.send_columns(path, indexes=[], columns=columns, strict=True)

    def rows(self, path: str, clock: Clock, columns: Iterable[Any]) -> None:
        """One row of `columns` for each row of `clock`."""
        indexes = [
            rr.TimeColumn("sim_time", duration=clock.time),
            # rerun counts in integers or in time: one second of this axis is one radian.
            rr.TimeColumn("phase", duration=clock.phase),
        ]
        self.stream.send_columns(path, indexes=indexes, columns=columns, strict=True)

    def clear(self, path: str, axis: str, moment: float) -> None:
        """Show nothing that moves of `path` and all below from `moment` [s] of one axis on."""
        index = rr.TimeColumn(axis, duration=[moment])
        columns = rr.Clear.columns(is_recursive=[True])
        self.stream.send_columns(path, indexes=[index], columns=columns, strict=True)

    def frames(self, path: str, clock: Clock, columns: Callable[[slice], Iterable[Any]]) -> None:
        """Rows too big for one piece; `columns` makes those of a slice of `clock`."""
        starts = range(0, len(clock.time), _BATCH)
        for start in progress(starts, total=len(starts), label=path.replace("\\", "")):
            rows = slice(start, min(start + _BATCH, len(clock.time)))
            self.rows(path, clock.at(rows), columns(rows))

    def series(
        self, path: str, clock: Clock, values: Vector, name: str, color: str, width: float = 1.5
    ) -> None:
        """A line of a time plot, shape (rows,); dots where numbers are lone or have gaps."""
        told = np.isfinite(values)
        if not told.any():
            return  # a chunk without rows makes the viewer's time panel fail
        first, last = np.flatnonzero(told)[[0, -1]]
        if first == last or not told[first:last].all():
            size = _DOT if first == last else _DOTS
            look = rr.SeriesPoints.columns(names=[name], colors=rgba(color), marker_sizes=[size])
        else:
            look = rr.SeriesLines.columns(
                names=[name],
                colors=rgba(color),
                widths=[width],
                aggregation_policy=[rr.components.AggregationPolicy.MinMax],  # no means of counts
            )
        self.static(path, look)
        self.rows(path, clock.at(told), rr.Scalars.columns(scalars=values[told]))
