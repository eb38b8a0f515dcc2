"""Diagrams of one quantity over another: the viewer has time plots only, so axes are drawn."""

from dataclasses import dataclass

import numpy as np
import rerun as rr
import rerun.blueprint as rrb

from squat.quantities import Vector
from squat.replay.recorder import Recorder, entity
from squat.replay.runs import Clock, Run
from squat.replay.style import GREY, PALE, rgba, ticks

_WIDTH = 160.0
_STILL = 25.0  # over lines that move (20), so that a curve shows within a trail; under points (30)
_HANGING = 5.0  # a label hangs so far below its point in the layout
_MARGIN = (24.0, 8.0, 14.0, 24.0)  # left, right, top, bottom


@dataclass(frozen=True)
class Chart:
    """Axes of a diagram: its entity, ranges and labels (with units) of x and y; 160 wide."""

    name: str
    title: str
    x: tuple[float, float]
    y: tuple[float, float]
    x_label: str
    y_label: str
    height: float = 60.0

    def canvas(self, x: Vector, y: Vector) -> Vector:
        """Points (..., 2) of the 2D view, y downward; what lies outside is cut to the frame."""
        places = [
            np.clip((values - low) / (high - low), 0, 1)
            for values, (low, high) in ((x, self.x), (y, self.y))
        ]
        return np.stack([places[0] * _WIDTH, (1 - places[1]) * self.height], axis=-1)

    def view(self, recorder: Recorder, runs: tuple[Run, ...]) -> rrb.View:
        """Send the axes, and return the view with the curves of `runs`."""
        axes = entity(None, "axes", self.name)
        self._frame(recorder, axes)
        left, right, top, bottom = _MARGIN
        paths = [axes, *(entity(run, "profiles", self.name) for run in runs)]
        return rrb.Spatial2DView(
            origin=axes,
            contents=[f"+ /{path}/**" for path in paths],
            name=self.title,
            visual_bounds=rrb.VisualBounds2D(
                x_range=(-left, _WIDTH + right), y_range=(-top, self.height + bottom)
            ),
        )

    def _frame(self, recorder: Recorder, axes: str) -> None:
        """Frame, grid and numbers."""
        (x0, x1), (y0, y1) = self.x, self.y
        across, up = ticks(x0, x1), ticks(y0, y1)
        box = self.canvas(np.array([x0, x1, x1, x0, x0]), np.array([y0, y0, y1, y1, y0]))
        grid = [self.canvas(np.full(2, x), np.array(self.y)) for x in across]
        grid += [self.canvas(np.array(self.x), np.full(2, y)) for y in up]
        strips = rr.LineStrips2D.columns(
            strips=[box, *grid],
            colors=rgba(GREY, *[f"{GREY}55"] * len(grid)),
            radii=rr.Radius.ui_points([0.8] + [0.4] * len(grid)),
        )
        recorder.static(f"{axes}/frame", strips.partition([len(grid) + 1]))
        below = self.canvas(across, np.full(len(across), y0)) + np.array([0, 1])
        beside = self.canvas(np.full(len(up), x0), up) - np.array([9, _HANGING])
        names = [[_WIDTH / 2, self.height + 11], [_WIDTH / 2, -11]]
        points = np.concatenate([below, beside, names])
        texts = [f"{value:g}" for value in (*across, *up)] + [self.x_label, self.y_label]
        recorder.static(f"{axes}/numbers", _labels(points, texts))

    def curve(
        self,
        recorder: Recorder,
        run: Run,
        name: str,
        clock: Clock,
        lines: list[Vector],
        color: str,
        width: float = 2.0,
    ) -> None:
        """A line for each row of `clock`: points (n, 2) in data coordinates, n of each its own."""
        strips = [self.canvas(*line.T) for line in lines]
        path = entity(run, "profiles", self.name, name)
        radius = rr.Radius.ui_points([width / 2])
        recorder.static(path, rr.LineStrips2D.columns(colors=rgba(color), radii=radius))
        recorder.rows(path, clock, rr.LineStrips2D.columns(strips=strips))

    def still(
        self, recorder: Recorder, run: Run, name: str, lines: list[Vector], color: str, width: float
    ) -> None:
        """Lines (n, 2) that hold at all times; what leaves the frame is left out."""
        strips = [self.canvas(*piece.T) for line in lines for piece in self._within(line)]
        if not strips:
            return
        style = rr.LineStrips2D.columns(
            colors=rgba(color), radii=rr.Radius.ui_points([width / 2]), draw_order=[_STILL]
        )
        path = entity(run, "profiles", self.name, name)
        recorder.static(path, rr.LineStrips2D.columns(strips=strips).partition([len(strips)]))
        recorder.static(path, style)

    def _within(self, line: Vector) -> list[Vector]:
        """Pieces of a line (n, 2) inside the frame."""
        low, high = np.array([self.x, self.y]).T
        inside = np.all((low <= line) & (line <= high), axis=1)
        starts = np.flatnonzero(np.diff(inside)) + 1
        pieces = zip(np.split(line, starts), inside[[0, *starts]], strict=True)
        return [piece for piece, seen in pieces if seen and len(piece) > 1]

    def point(
        self, recorder: Recorder, run: Run, name: str, clock: Clock, points: Vector, color: str
    ) -> None:
        """A point for each row of `clock`: (rows, 2) in data coordinates."""
        path = entity(run, "profiles", self.name, name)
        recorder.static(path, _dot(color))
        recorder.rows(path, clock, rr.Points2D.columns(positions=self.canvas(*points.T)))

    def mark(
        self, recorder: Recorder, run: Run, name: str, place: tuple[float, float], color: str
    ) -> None:
        """A point that stands still, with its name; none where it lies outside the frame."""
        (x0, x1), (y0, y1) = self.x, self.y
        if not (x0 <= place[0] <= x1 and y0 <= place[1] <= y1):
            return
        path = entity(run, "profiles", self.name, name)
        position = self.canvas(*np.array(place))
        recorder.static(path, rr.Points2D.columns(positions=[position], labels=[name]))
        recorder.static(path, rr.Points2D.columns(show_labels=[True]))
        recorder.static(path, _dot(color))


def _dot(color: str) -> rr.ComponentColumnList:
    return rr.Points2D.columns(colors=rgba(color), radii=rr.Radius.ui_points([5.0]))


def _labels(points: Vector, texts: list[str]) -> rr.ComponentColumnList:
    """Texts at points of a 2D view."""
    count = len(points)
    columns = rr.Points2D.columns(
        positions=points,
        labels=texts,
        colors=rgba(*[PALE] * count),
        radii=rr.Radius.ui_points([0.0] * count),
    )
    shown = rr.Points2D.columns(show_labels=[True])
    return rr.ComponentColumnList([*columns.partition([count]), *shown])
