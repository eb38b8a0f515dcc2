"""Curves over time, of one run or overlaid, and their differences.

A plot is an entry of `PLOTS`; it appears where a record holds the variables that it needs.
"""

from collections.abc import Callable
from typing import NamedTuple

import numpy as np
import rerun.blueprint as rrb
import xarray as xr

from squat.quantities import Vector
from squat.replay.panels import Draw, Place, panel
from squat.replay.recorder import Recorder, entity
from squat.replay.runs import Clock, Run
from squat.replay.style import GREEN, ORANGE, PURPLE, RED, SKY, run_color

Values = Callable[[xr.Dataset], xr.DataArray]


class Curve(NamedTuple):
    """One line: entity, values (time,) or () of a record, name in the legend, colour.

    `compared` curves are overlaid where there are several runs, and their differences drawn; a
    `width` [points] beyond the others' shows a curve below one that it should agree with.
    """

    name: str
    values: Values
    label: str
    color: str
    compared: bool = False
    width: float = 1.5


class Plot(NamedTuple):
    """One diagram over time: entity, title with unit, variables, lines.

    `least_span` of the vertical axis keeps rounding from filling the diagram; `constants` is the
    common name of constant lines where there are several runs.
    """

    name: str
    title: str
    needs: tuple[str, ...]
    curves: tuple[Curve, ...]
    legend: rrb.Corner2D = rrb.Corner2D.RightTop
    least_span: float = 0.0
    constants: str = ""


def variable(name: str) -> Values:
    """The variable itself."""
    return lambda data: data[name]


def counts(data: xr.Dataset) -> xr.DataArray:
    """Iterations of the steps taken: the start takes none."""
    return data["iterations"].where(data["iterations"] > 0)


def since_start(*names: str) -> Values:
    """Change of the sum of `names` since the start, in millions."""
    return lambda data: sum(data[name] - data[name][0] for name in names) / 1e6  # type: ignore[return-value]


def error(data: xr.Dataset) -> xr.DataArray:
    """Distance of the piston from its exact position."""
    return data["position"] - data["exact_position"]


def failed_contraction(data: xr.Dataset) -> xr.DataArray:
    """Contraction of the step that did not converge, where the record tells it."""
    return data.get("failed_contraction", xr.DataArray(np.nan))


PLOTS = (
    Plot(
        "heave",
        "Heave w [m]",
        ("heave", "stable_root", "unstable_root"),
        (
            Curve("heave", variable("heave"), "w", SKY, compared=True),
            Curve("stable_root", variable("stable_root"), "stable root", GREEN, True, 0.75),
            Curve("unstable_root", variable("unstable_root"), "unstable root", RED, True, 0.75),
        ),
        rrb.Corner2D.LeftBottom,
        constants="roots of Eq. (27)",
    ),
    Plot(
        "position",
        "Position w [m]",
        ("position", "exact_position"),
        (
            Curve("exact_position", variable("exact_position"), "exact, Eq. (5)", ORANGE, width=4),
            Curve("position", variable("position"), "w", SKY, compared=True),
        ),
    ),
    Plot(
        "error",
        "Error of the position [m]",
        ("position", "exact_position"),
        (Curve("error", error, "w less exact", PURPLE, compared=True),),
    ),
    Plot(
        "iterations",
        "Iterations of a step",
        ("iterations",),
        (Curve("iterations", counts, "iterations", SKY, compared=True),),
    ),
    Plot(
        "ship_energies",
        "Ship energies since start [MJ/m]",
        ("kinetic_energy", "potential_energy", "fluid_work"),
        (
            Curve("kinetic", since_start("kinetic_energy"), "E_c", RED, compared=True),
            Curve("potential", since_start("potential_energy"), "E_p", SKY),
            Curve("work", since_start("fluid_work"), "W", GREEN),
            Curve(
                "sum",
                since_start("kinetic_energy", "potential_energy", "fluid_work"),
                "sum",
                PURPLE,
            ),
        ),
    ),
    Plot(
        "piston_energies",
        "Energies of all [J]",
        ("kinetic_energy", "potential_energy", "exact_position"),
        (
            Curve("kinetic", variable("kinetic_energy"), "kinetic", RED, compared=True),
            Curve("potential", variable("potential_energy"), "potential", SKY),
            Curve(
                "sum",
                lambda data: data["kinetic_energy"] + data["potential_energy"],
                "sum",
                PURPLE,
                compared=True,
            ),
        ),
    ),
    Plot(
        "contraction",
        "Contraction factor",
        ("contraction", "predicted_contraction"),
        (
            Curve("expected", variable("predicted_contraction"), "predicted G", ORANGE, width=4),
            Curve("failed_step", failed_contraction, "measured, failed step", RED),
            Curve("measured", variable("contraction"), "measured", SKY, compared=True),
        ),
        least_span=0.02,
    ),
)


def time_view(plot: Plot, title: str, paths: list[str], shown: list[Vector]) -> rrb.View:
    """A diagram over time of all entities below `paths`, which hold the values `shown`."""
    return rrb.TimeSeriesView(
        origin="/",
        contents=[f"+ /{path}/**" for path in paths],
        name=title,
        axis_x=rrb.TimeAxis(link=rrb.components.LinkAxis.LinkToGlobal),
        axis_y=_axis(shown, plot.least_span),
        plot_legend=rrb.PlotLegend(plot.legend),
    )


def _axis(shown: list[Vector], least: float) -> rrb.ScalarAxis | None:
    """Axis around `shown` as wide as `least`; None, the viewer's choice, where they need more."""
    told = np.concatenate([values[np.isfinite(values)] for values in shown])
    if not told.size or np.ptp(told) >= least:
        return None
    middle = float(told.max() + told.min()) / 2
    return rrb.ScalarAxis(range=(middle - least / 2, middle + least / 2))


def _overlaid(plot: Plot) -> Draw:
    """Every curve of a single run; of several the compared ones, and what is constant."""

    def draw(recorder: Recorder, runs: tuple[Run, ...]) -> list[rrb.View]:
        shown = []
        for number, run in enumerate(runs):
            for curve in plot.curves:
                values = curve.values(run.data)
                if run.label and not curve.compared:
                    continue
                clock, told = _rows(run, values)
                shown.append(told)
                color = run_color(number) if run.label else curve.color
                path = entity(run, "plots", plot.name, curve.name)
                several = bool(run.label) and not values.ndim
                label = run.said(plot.constants if several else curve.label)
                recorder.series(path, clock, told, label, color, curve.width)
        paths = [entity(run, "plots", plot.name) for run in runs]
        return [time_view(plot, plot.title, paths, shown)]

    return draw


def _rows(run: Run, values: xr.DataArray) -> tuple[Clock, Vector]:
    """Rows of a curve; a constant has one at either end."""
    if values.ndim:
        return run.steps, np.asarray(values.values, float)
    return run.span, np.full(len(run.span.time), float(values))


def _differing(plot: Plot) -> Draw:
    """What compared curves differ by from the first run's."""

    def draw(recorder: Recorder, runs: tuple[Run, ...]) -> list[rrb.View]:
        first, *others = runs
        paths, shown = [], []
        for number, run in enumerate(others, 1):
            for curve in _varying(plot, run):
                clock, values = difference(first, run, curve.values)
                shown.append(values)
                path = entity(run, "differences", plot.name, curve.name)
                label = f"{run.label} less {first.label}"
                name = label if len(_varying(plot, run)) == 1 else f"{curve.label}: {label}"
                recorder.series(path, clock, values, name, run_color(number))
            paths.append(entity(run, "differences", plot.name))
        return [time_view(plot, f"Δ {plot.title}", paths, shown)] if others else []

    return draw


def _varying(plot: Plot, run: Run) -> list[Curve]:
    return [curve for curve in plot.curves if curve.compared and curve.values(run.data).ndim]


def difference(first: Run, run: Run, values: Values) -> tuple[Clock, Vector]:
    """`run` less `first` at the first's steps within both runs; linear between the other's."""
    time, other = first.steps.time, run.steps.time
    common = time <= other[-1] * (1 + 1e-12)
    clock = first.steps.at(common)
    there = np.interp(clock.time, other, np.asarray(values(run.data).values, float))
    return clock, there - np.asarray(values(first.data).values, float)[common]


for _plot in PLOTS:
    panel(_plot.name, Place.PLOT, _plot.needs)(_overlaid(_plot))
    panel(f"{_plot.name} differences", Place.DIFFERENCE, _plot.needs)(_differing(_plot))
