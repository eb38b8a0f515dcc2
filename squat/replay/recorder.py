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

_DOT = 4.0  # size of the only point of a curve, points
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
        """A line of a time plot, shape (rows,), of one row a dot; what is no number is left out."""
        told = np.isfinite(values)
        if not told.any():
            return  # a chunk without rows makes the viewer's time panel fail
        if told.sum() == 1:
            look = rr.SeriesPoints.columns(names=[name], colors=rgba(color), marker_sizes=[_DOT])
        else:
            look = rr.SeriesLines.columns(
                names=[name],
                colors=rgba(color),
                widths=[width],
                aggregation_policy=[rr.components.AggregationPolicy.MinMax],  # no means of counts
            )
        self.static(path, look)
        self.rows(path, clock.at(told), rr.Scalars.columns(scalars=values[told]))
