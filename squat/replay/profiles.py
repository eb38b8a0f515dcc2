"""Distributions at the time shown: pressure under the keel, residuals of the iteration."""

import numpy as np
import rerun.blueprint as rrb
from numpy.typing import NDArray

from squat.quantities import Vector
from squat.replay.chart import Chart
from squat.replay.moved import moved
from squat.replay.panels import Place, panel
from squat.replay.recorder import Recorder
from squat.replay.runs import Run
from squat.replay.style import ORANGE, RED, SKY, run_color
from squat.stability.keel import breaks, keel_pressure, underside

_SEEN = (0.05, 0.95)  # shares of the 2D values that the axes hold: corners are singular
_WIDE = 5.0  # pixels of the 1D line, which shows beside a 2D one that lies upon it
_BEYOND = 2.0  # spans of those: up to so many all values are shown
_FAR = 5.0  # 1D values over this many spans of those would hide them


def keel(run: Run) -> NDArray[np.int64]:
    """Numbers of the hull's nodes on its underside."""
    return underside(run.data["hull_x"].values, run.data["hull_z"].values)


def dynamic_pressure(run: Run) -> Vector:
    """Pressure less p_atm + rho g (H - z) at the underside's nodes, (time, keel) [kPa]."""
    water, nodes = run.config["water"], keel(run)
    rest = np.column_stack([run.data[f"hull_{axis}"].values[nodes] for axis in "xz"])
    z = moved(run, rest, run.steps.time)[..., 1]
    head = run.config["channel"]["depth"] - z
    static = water["density"] * water["gravity"] * head
    return np.asarray(run.data["hull_pressure"].values[:, nodes] - static) / 1000


def uniform_pressure(run: Run) -> Vector:
    """The same of the one-dimensional model, (time,) [kPa]."""
    config = run.config
    depth = config["channel"]["depth"]
    clearance = depth - config["hull"]["draft"] + run.data["heave"].values
    density = config["water"]["density"]
    return keel_pressure(density, float(run.data.attrs["current"]), depth, clearance) / 1000


@panel("keel_pressure", Place.PROFILE, ("hull_pressure", "hull_x", "hull_z", "heave"))
def keel_pressure_panel(recorder: Recorder, runs: tuple[Run, ...]) -> list[rrb.View]:
    """Dynamic pressure along the keel, beside the uniform one of Eq. (27)."""
    fields, uniform = [dynamic_pressure(run) for run in runs], [uniform_pressure(r) for r in runs]
    x = [run.data["hull_x"].values[keel(run)] for run in runs]
    seen = [0.0, *np.ravel([_ends(field) for field in fields])]
    chart = Chart(
        "keel_pressure",
        "Pressure under the keel",
        _span([float(end) for along in x for end in (along[0], along[-1])], 0.0),
        _span([*seen, *_levels(np.concatenate(uniform), float(np.ptp(seen)))]),
        "x from the bow [m]",
        "pressure less hydrostatic [kPa]",
    )
    low, high = chart.y
    if any(((low <= level) & (level <= high)).any() for level in uniform):
        chart.title += "; level line: 1D, Eq. (27)"
    if any(run.data.attrs["status"] == "grounded" for run in runs):
        chart.y_label += "; grounded: noise"
    for run, along, field, level in zip(runs, x, fields, uniform, strict=True):
        apart = breaks(keel(run))
        lines = [np.insert(np.column_stack([along, row]), apart, np.nan, axis=0) for row in field]
        flat = [np.column_stack([along[[0, -1]], [value, value]]) for value in level]
        several = bool(run.label)
        color = run_color(run.number)
        shade = color if several else ORANGE
        chart.curve(recorder, run, "one_dimensional", run.steps, flat, shade, _WIDE, under=True)
        chart.curve(recorder, run, "two_dimensional", run.steps, lines, color if several else SKY)
    return [chart.view(recorder, runs)]


def _ends(field: Vector) -> Vector:
    """Least and greatest value, or those of the bulk where corners, or a fall, go far beyond."""
    ends, bulk = np.quantile(field, (0, 1)), np.quantile(field, _SEEN)
    return ends if np.ptp(ends) <= _BEYOND * np.ptp(bulk) else bulk


def _levels(levels: Vector, span: float) -> Vector:
    """Ends of the 1D values; of their bulk where some lie far beyond the 2D `span`: gaps close."""
    far = np.ptp(levels) > _FAR * span
    return np.quantile(levels, _SEEN if far else (0, 1))


@panel("residuals", Place.PROFILE, ("residual", "failed_residual", "iterations"))
def residuals(recorder: Recorder, runs: tuple[Run, ...]) -> list[rrb.View]:
    """Residual of every iteration of the step shown, and of the step that failed."""
    taken = [_lines(run.data["residual"].values) for run in runs]
    failed = [_line(run.data["failed_residual"].values) for run in runs]
    # Beside a step that fails none that is accepted could be seen: of each run what it has.
    points = [
        line
        for lines, failure in zip(taken, failed, strict=True)
        for line in ([line for line in lines if len(line)] or [failure])
        if len(line)
    ]
    if not points:
        return []
    both = np.concatenate(points)
    chart = Chart(
        "residuals",
        "Residuals of the step"
        + ("; red: of the one that failed" if any(map(len, failed)) else ""),
        _span([0.0, float(both[:, 0].max())], 0.0),
        _span([float(both[:, 1].min()), float(both[:, 1].max())]),
        "iteration",
        "log10 |w^(k+1) - w^k| [m]",
    )
    for run, lines, failure in zip(runs, taken, failed, strict=True):
        shown = [n for n, line in enumerate(lines) if len(line)]
        color = run_color(run.number) if run.label else SKY
        if shown:
            rows = [lines[n] for n in shown]
            chart.curve(recorder, run, "step", run.steps.at(shown), rows, color)
        if run.failure is not None:
            chart.curve(recorder, run, "failed_step", run.failure, [failure], RED)
    return [chart.view(recorder, runs)]


def _lines(table: Vector) -> list[Vector]:
    return [_line(row[np.isfinite(row)]) for row in table]


def _line(residual: Vector) -> Vector:
    """Points (n, 2): number of the iteration, logarithm of its residual where that is not 0."""
    number = np.arange(1, len(residual) + 1)
    told = np.isfinite(residual) & (residual > 0)
    return np.column_stack([number[told], np.log10(residual[told])])


def _span(values: list[float], margin: float = 0.05) -> tuple[float, float]:
    """Range of `values` with a margin; never empty."""
    low, high = min(values), max(values)
    size = (high - low) or 1.0
    return low - margin * size, high + margin * size
