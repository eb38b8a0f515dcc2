"""Diagrams of one quantity over another: the viewer has time plots only, so axes are drawn."""

from dataclasses import dataclass, field

import numpy as np
import rerun as rr
import rerun.blueprint as rrb

from squat.quantities import Vector
from squat.replay.cut import pieces, within
from squat.replay.recorder import Recorder, entity
from squat.replay.runs import Clock, Run
from squat.replay.style import GREY, PALE, rgba, ticks

_WIDTH = 160.0
_STILL = 25.0  # over lines that move (20), so that a curve shows within a trail; under points (30)
_UNDER = 15.0
_HANGING = 5.0  # a label hangs so far below its point in the layout
_MARGIN = (24.0, 8.0, 14.0, 24.0)  # left, right, top, bottom


@dataclass
class Chart:
    """Axes of a diagram: its entity, ranges and labels (with units) of x and y; 160 wide.

    What leaves the frame is cut there, and the label of y says so.
    """

    name: str
    title: str
    x: tuple[float, float]
    y: tuple[float, float]
    x_label: str
    y_label: str
    height: float = 60.0
    cut: bool = field(default=False, init=False)

    def canvas(self, x: Vector, y: Vector) -> Vector:
        """Points (..., 2) of the 2D view, y downward."""
        places = [
            (values - low) / (high - low) for values, (low, high) in ((x, self.x), (y, self.y))
        ]
        return np.stack([places[0] * _WIDTH, (1 - places[1]) * self.height], axis=-1)

    def view(self, recorder: Recorder, runs: tuple[Run, ...]) -> rrb.View:
        """Send the axes, and return the view with the curves of `runs`, which are sent before."""
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
        y_label = f"{self.y_label}; cut at the frame" if self.cut else self.y_label
        texts = [f"{value:g}" for value in (*across, *up)] + [self.x_label, y_label]
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
        *,
        under: bool = False,
    ) -> None:
        """A line for each row of `clock`: points (n, 2) in data coordinates, n of each its own.

        It lies `under` the others if asked for.
        """
        parts = [pieces(line, *self._corners) for line in lines]
        told = [line[np.isfinite(line).all(axis=1)] for line in lines]
        self.cut |= not all(within(line, *self._corners).all() for line in told)
        strips = [self.canvas(*piece.T) for part in parts for piece in part]
        path = entity(run, "profiles", self.name, name)
        radius = rr.Radius.ui_points([width / 2])
        recorder.static(path, rr.LineStrips2D.columns(colors=rgba(color), radii=radius))
        if under:
            recorder.static(path, rr.LineStrips2D.columns(draw_order=[_UNDER]))
        columns = rr.LineStrips2D.columns(strips=strips)
        recorder.rows(path, clock, columns.partition([len(part) for part in parts]))

    def still(
        self, recorder: Recorder, run: Run, name: str, lines: list[Vector], color: str, width: float
    ) -> None:
        """Lines (n, 2) that hold at all times; what leaves the frame is left out."""
        strips = [self.canvas(*piece.T) for line in lines for piece in pieces(line, *self._corners)]
        if not strips:
            return
        style = rr.LineStrips2D.columns(
            colors=rgba(color), radii=rr.Radius.ui_points([width / 2]), draw_order=[_STILL]
        )
        path = entity(run, "profiles", self.name, name)
        recorder.static(path, rr.LineStrips2D.columns(strips=strips).partition([len(strips)]))
        recorder.static(path, style)

    @property
    def _corners(self) -> tuple[Vector, Vector]:
        """Lower left and upper right corner (2,) of the frame."""
        low, high = np.array([self.x, self.y]).T
        return low, high

    def point(
        self, recorder: Recorder, run: Run, name: str, clock: Clock, points: Vector, color: str
    ) -> None:
        """A point for each row of `clock`: (rows, 2) in data coordinates."""
        path = entity(run, "profiles", self.name, name)
        inside = within(points, *self._corners)
        self.cut |= not inside.all()
        recorder.static(path, _dot(color))
        columns = rr.Points2D.columns(positions=self.canvas(*points[inside].T))
        recorder.rows(path, clock, columns.partition(inside.astype(int)))

    def mark(
        self, recorder: Recorder, run: Run, name: str, place: tuple[float, float], color: str
    ) -> None:
        """A point that stands still, with its name; none where it lies outside the frame."""
        if not within(np.array(place), *self._corners):
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
