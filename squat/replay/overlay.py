"""Plots over time: of one run, or overlaid with their differences."""

import numpy as np
import rerun.blueprint as rrb

from squat.quantities import Vector
from squat.replay.panels import Draw, Place, panel
from squat.replay.plots import PLOTS, Curve, Plot
from squat.replay.recorder import Recorder, entity
from squat.replay.runs import Clock, Run
from squat.replay.style import run_color, ticked

_NUMBERED = 20.0, 300.0
"""Lengths [s] for which the viewer has more than one number on the axis of a narrow diagram."""
_NAME, _LEGEND = 0.12, 0.5
"""Share of a diagram's height that a name in its legend takes, and that all may take."""
_FAR = 5.0
"""Spans of what moves: a bound further off is left out."""
_EDGE = 0.06
"""Share of what curves span that is left above and below where one of them is a dot."""
Named = list[tuple[str, Vector]]
"""Names in the legend with the values of their curves."""


def time_view(
    plot: Plot, title: str, paths: list[str], shown: Named, runs: tuple[Run, ...]
) -> rrb.View:
    """A diagram over time of all entities below `paths`, which hold the curves `shown`.

    Several runs have their legend, whose names may be long, above or below the curves; a single
    run has it where curves go to its corner: a ship's first trough, and counts that stay level.
    """
    free = len(runs) == 1 and plot.legend is rrb.Corner2D.RightTop and plot.base is None
    names = {name for name, told in shown if np.isfinite(told).any()}
    room = 0.0 if free else min(_NAME * len(names), _LEGEND)
    above, below = (room, 0.0) if plot.legend is rrb.Corner2D.RightTop else (0.0, room)
    return rrb.TimeSeriesView(
        origin="/",
        contents=[f"+ /{path}/**" for path in paths],
        name=title,
        axis_x=time_axis(_last(runs)),
        axis_y=_axis(shown, plot.least_span, above, below, plot.base),
        plot_legend=rrb.PlotLegend(plot.legend),
    )


def time_axis(last: float) -> rrb.TimeAxis:
    """Axis from 0 to `last` [s], the same in all diagrams.

    Linked axes would each begin with the times of their own curves, and show 30 s before and after
    the one played at most.
    """
    ends = (rrb.TimeRangeBoundary.absolute(seconds=time) for time in (0.0, last))
    return rrb.TimeAxis(view_range=rrb.TimeRange(*ends))


def _last(runs: tuple[Run, ...]) -> float:
    return max(float(run.span.time[-1]) for run in runs)


def _axis(
    shown: Named, least: float, above: float, below: float = 0.0, base: float | None = None
) -> rrb.ScalarAxis | None:
    """Axis around `shown`, `least` wide, with numbers; None where the viewer's own has them.

    A share of it, `above` or `below`, is left to the legend; there it may cover level lines. What
    is drawn stands off the ends.
    """
    told = _finite([values for _, values in shown])
    if not told.size:
        return None
    low, high = float(told.min()), float(told.max())
    low = low if base is None else min(low, base)
    if high - low < least:
        middle = (low + high) / 2
        return rrb.ScalarAxis(range=(middle - least / 2, middle + least * (1 / (1 - above) - 0.5)))
    apart = base is not None or any(values.size == 1 for _, values in shown)
    edge = _EDGE * (high - low) if apart else 0.0
    moving = _finite([values for _, values in shown if values.size > 2])
    deep = (high - float(moving.min())) / (1 - below) if below and moving.size else 0.0
    lowest = min(low - edge if base is None else low, high - deep)
    wide = ticked(lowest, high + edge + (high - low) * above / (1 - above))
    if wide == (low, high):
        return None
    room = _EDGE * (wide[1] - wide[0])
    return rrb.ScalarAxis(range=(min(wide[0], low - room), max(wide[1], high + room)))


def _finite(values: list[Vector]) -> Vector:
    """All finite ones."""
    return np.concatenate([np.empty(0), *(one[np.isfinite(one)] for one in values)])


def _overlaid(plot: Plot) -> Draw:
    """Every curve of a single run; of several the compared ones, and what is constant."""

    def draw(recorder: Recorder, runs: tuple[Run, ...]) -> list[rrb.View]:
        shown: Named = []
        curves = [curve for curve in plot.curves if _drawn(curve, plot, runs)]
        for run in runs:
            for curve in curves:
                own = bool(run.label) and not _one_for_all(curve, runs)
                clock, told = _rows(run, curve)
                color = run_color(run.number) if own else curve.color
                path = entity(run, "plots", plot.name, curve.name)
                label = _name(plot, curve, run) if own else curve.label
                shown.append((label, told))
                recorder.series(path, clock, told, label, color, curve.width)
        paths = [entity(run, "plots", plot.name) for run in runs]
        title = plot.several if len(runs) > 1 and plot.several else plot.title
        if not _finite([values for _, values in shown]).size:
            stepless = all(len(run.steps.time) == 1 for run in runs)
            title += ": no step was accepted" if stepless else ": no values"
        elif not _NUMBERED[0] <= (last := _last(runs)) <= _NUMBERED[1]:
            title += f"; 0 to {last:.3g} s"
        title += "".join(_told(curve, runs) for curve in plot.curves if curve not in curves)
        return [time_view(plot, title, paths, shown, runs)]

    return draw


def _drawn(curve: Curve, plot: Plot, runs: tuple[Run, ...]) -> bool:
    """Whether the curve is told: of several runs what is compared, or a constant they share."""
    if len(runs) > 1:
        constant = not (curve.last or curve.values(runs[0].data).ndim)
        if not curve.compared or (constant and not _one_for_all(curve, runs)):
            return False
    return not (curve.bound and _far_off(curve, plot, runs))


def _told(curve: Curve, runs: tuple[Run, ...]) -> str:
    """What the title says of a last moment that lies too far off to be drawn."""
    if not (curve.last and curve.compared):
        return ""
    values = _finite([np.ravel(curve.values(run.data).values) for run in runs])
    return f"; {curve.label}: {', '.join(f'{value:.3g}' for value in values)}"


def _far_off(curve: Curve, plot: Plot, runs: tuple[Run, ...]) -> bool:
    """Whether the curve lies so far from the plot's others that it would flatten them."""
    others = [one for one in plot.curves if not one.bound and _drawn(one, plot, runs)]
    seen, own = (
        _finite([np.ravel(one.values(run.data).values) for one in some for run in runs])
        for some in (others, [curve])
    )
    if not (seen.size and own.size):
        return False
    apart = max(seen.min() - own.min(), own.max() - seen.max())
    return bool(apart > _FAR * max(np.ptp(seen), plot.least_span) and np.ptp(seen) > 0)


def _one_for_all(curve: Curve, runs: tuple[Run, ...]) -> bool:
    """Whether the curve is a constant that all runs share."""
    values = [curve.values(run.data) for run in runs]
    if values[0].ndim:
        return False
    return bool(np.allclose(values, values[0], rtol=1e-9, atol=0, equal_nan=True))


def _name(plot: Plot, curve: Curve, run: Run) -> str:
    """Name in the legend of several runs: the run's, or both where it does not tell the curve."""
    alone = _varying(plot, run) == [curve]
    return run.label if alone else run.said(curve.label)


def _rows(run: Run, curve: Curve) -> tuple[Clock, Vector]:
    """Rows of a curve; a constant has one at either end, or at the last moment alone."""
    values = curve.values(run.data)
    if values.ndim:
        return run.steps, np.asarray(values.values, float)
    clock = run.span.at([-1]) if curve.last else run.span
    return clock, np.full(len(clock.time), float(values))


def _differing(plot: Plot) -> Draw:
    """What compared curves differ by from the first run's."""

    def draw(recorder: Recorder, runs: tuple[Run, ...]) -> list[rrb.View]:
        first, *others = runs
        paths: list[str] = []
        shown: Named = []
        for run in others:
            for curve in _varying(plot, run):
                clock, values = difference(first, run, curve)
                if len(values) < 2:  # the start alone is no common step
                    continue
                name = _name(plot, curve, run)
                shown.append((name, values))
                path = entity(run, "differences", plot.name, curve.name)
                recorder.series(path, clock, values, name, run_color(run.number))
            paths.append(entity(run, "differences", plot.name))
        title = _titled(plot, first, others, any(np.isfinite(told).any() for _, told in shown))
        placed = plot._replace(legend=rrb.Corner2D.RightTop)  # they start from 0, anywhere
        return [time_view(placed, title, paths, shown, runs)] if others else []

    return draw


def _titled(plot: Plot, first: Run, others: list[Run], any_told: bool) -> str:
    """Title of differences, with what is missing."""
    apart = [run.label for run in others if min(len(run.steps.time), len(first.steps.time)) < 2]
    if len(apart) == len(others):
        return f"Δ {plot.title}: no common step"
    if not any_told:
        return f"Δ {plot.title}: none in common"
    missing = f"; no common step with {', '.join(apart)}" if apart else ""
    return f"Δ {plot.title}, less {first.label}{missing}"


def _varying(plot: Plot, run: Run) -> list[Curve]:
    return [curve for curve in plot.curves if curve.compared and curve.values(run.data).ndim]


def difference(first: Run, run: Run, curve: Curve) -> tuple[Clock, Vector]:
    """`run` less `first` at the first's steps within both runs; linear between the other's.

    Whole numbers are those of the other's step in which the moment lies.
    """
    time, other = first.steps.time, run.steps.time
    common = time <= other[-1] * (1 + 1e-12)
    clock = first.steps.at(common)
    here, values = (np.asarray(curve.values(data).values, float) for data in (first.data, run.data))
    if curve.whole:
        within = np.searchsorted(other, clock.time * (1 - 1e-12))
        return clock, values[within] - here[common]
    return clock, np.interp(clock.time, other, values) - here[common]


for _plot in PLOTS:
    _beside = Place.DIFFERENCE if _plot.place is Place.PLOT else _plot.place
    panel(_plot.name, _plot.place, _plot.needs)(_overlaid(_plot))
    panel(f"{_plot.name} differences", _beside, _plot.needs)(_differing(_plot))
