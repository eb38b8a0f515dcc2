"""The run as a point: on its curve of constant energy, and on the potential that it moves in."""

import numpy as np
import rerun.blueprint as rrb

from squat.quantities import Vector
from squat.replay.chart import Chart
from squat.replay.landscape import NEEDS, Landscape, energy, kinetic
from squat.replay.panels import Place, panel
from squat.replay.recorder import Recorder
from squat.replay.runs import Run
from squat.replay.style import GREEN, GREY, ORANGE, PALE, RED, SKY, run_color

_LEVELS = (0.1, 0.3, 0.55, 0.8, 1.25, 1.6, 2.1)  # over the depth of the well, as in the figures
_HEIGHT = 110.0
_TRAIL = 2 * np.pi * (1 + 1e-9)  # rad of phase; a whole period in spite of rounding
_WIDE = 5.0  # points: the trail shows beside a curve that it should lie on
_DEEP = 0.1  # share of the steps that may fall below the diagram: a grounding ship falls far
_THOUSAND = 1e3
_MARKS = {"stable": GREEN, "unstable": RED}


@panel("phase_portrait", Place.ENERGY, NEEDS)
def phase_portrait(recorder: Recorder, runs: tuple[Run, ...]) -> list[rrb.View]:
    """Velocity over heave: separatrix, curve of the start's energy, the point and its trail."""
    lands = [Landscape.of(run) for run in runs]
    fastest = max(
        land.fastest(run.data["heave_velocity"].values)
        for land, run in zip(lands, runs, strict=True)
    )
    x = _window(lands, runs)
    near = any(x[0] < land.unstable < x[1] for land in lands)
    edge = ("; wide: separatrix" if len(runs) > 1 else "; red: separatrix") if near else ""
    chart = Chart(
        "phase_portrait",
        f"Phase portrait; {'thin' if len(runs) > 1 else 'blue'}: energy of the start{edge}",
        x,
        (-fastest, fastest),
        "heave w [m]",
        "velocity w' [m/s]",
        _HEIGHT,
    )
    for run, land in zip(runs, lands, strict=True):
        _levels(recorder, chart, run, land)
        points = np.column_stack([run.data[name].values for name in ("heave", "heave_velocity")])
        color = run_color(run.number) if run.label else ORANGE
        chart.curve(recorder, run, "trail", run.steps, trail(run, points), color, _WIDE)
        chart.point(recorder, run, "ship", run.steps, points, color)
        for name, w in land.equilibria.items():
            chart.mark(recorder, run, name, (w, 0.0), _MARKS[name])
    return [chart.view(recorder, runs)]


def _levels(recorder: Recorder, chart: Chart, run: Run, land: Landscape) -> None:
    """Curves of constant energy; the grey ones of a single run only."""
    top, low, high = land.barrier, *chart.x
    well = float(land.potential(land.stable))
    color = run_color(run.number)
    own = land.level(float(run.data["initial_energy"]), low, high)
    if np.isfinite(top):
        if not run.label:
            levels = [well + (top - well) * share for share in _LEVELS]
            halves = [half for level in levels for half in land.level(level, low, high)]
            chart.still(recorder, run, "levels", _both(halves), GREY, 1)
        edge = _both(land.level(top, low, high))
        chart.still(recorder, run, "separatrix", edge, color if run.label else RED, 3)
    chart.still(recorder, run, "energy", _both(own), color if run.label else SKY, 1.5)


def _both(halves: list[Vector]) -> list[Vector]:
    """The halves with w' >= 0 and their mirror images."""
    return [half * np.array([1, way]) for half in halves for way in (1, -1)]


def trail(run: Run, points: Vector) -> list[Vector]:
    """The points of the last period of the time scale, up to each step."""
    phase = run.steps.phase
    first = np.searchsorted(phase, phase - _TRAIL)
    first = np.minimum(first, np.maximum(np.arange(len(phase)) - 1, 0))
    ends = np.maximum(np.arange(len(phase)) + 1, 2)  # a line has two points at least
    return [points[start:end] for start, end in zip(first, ends, strict=True)]


@panel("potential", Place.ENERGY, NEEDS)
def potential(recorder: Recorder, runs: tuple[Run, ...]) -> list[rrb.View]:
    """U over heave, E as a level line, and between them what is kinetic."""
    lands = [Landscape.of(run) for run in runs]
    x = _window(lands, runs)
    chart = Chart(
        "potential",
        "Potential energy U(w); level: E, bar: kinetic energy of ship and water",
        x,
        _energies(lands, runs, x),
        "heave w [m]",
        "U - U(0) [kJ/m]",
        _HEIGHT,
    )
    for run, land in zip(runs, lands, strict=True):
        _potential(recorder, chart, run, land)
    return [chart.view(recorder, runs)]


def _potential(recorder: Recorder, chart: Chart, run: Run, land: Landscape) -> None:
    w, total = run.data["heave"].values, _above_rest(land, energy(run))
    held = total - kinetic(run) / _THOUSAND
    along = np.linspace(*chart.x, 400)
    curve = np.column_stack([along, _above_rest(land, land.potential(along))])
    color = run_color(run.number) if run.label else ""
    chart.still(recorder, run, "potential", [curve], color or PALE, 2)
    levels = [np.column_stack([chart.x, [value, value]]) for value in total]
    chart.curve(recorder, run, "energy", run.steps, levels, color or SKY)
    bars = [np.array([[x, low], [x, high]]) for x, low, high in zip(w, held, total, strict=True)]
    chart.curve(recorder, run, "kinetic", run.steps, bars, color or ORANGE)
    chart.point(recorder, run, "ship", run.steps, np.column_stack([w, held]), color or ORANGE)
    for name, place in land.equilibria.items():
        height = float(_above_rest(land, land.potential(place)))
        chart.mark(recorder, run, name, (place, height), _MARKS[name])


def _above_rest(land: Landscape, values: Vector) -> Vector:
    """Energies [J/m] less U(0), in kJ/m."""
    return np.asarray((values - land.potential(0.0)) / _THOUSAND)


def _window(lands: list[Landscape], runs: tuple[Run, ...]) -> tuple[float, float]:
    """Heave [m] that both diagrams show."""
    windows = [land.window(run.data["heave"].values) for land, run in zip(lands, runs, strict=True)]
    return min(low for low, _ in windows), max(high for _, high in windows)


def _energies(
    lands: list[Landscape], runs: tuple[Run, ...], x: tuple[float, float]
) -> tuple[float, float]:
    """Energies [kJ/m] to show: the runs', and those of the equilibria within `x`."""
    shown: list[float] = []
    for land, run in zip(lands, runs, strict=True):
        total = energy(run)
        within = [w for w in land.equilibria.values() if x[0] < w < x[1]]
        held = np.quantile(total - kinetic(run), _DEEP)
        shown += _above_rest(land, np.array([*total, held, *land.potential(within)])).tolist()
    low, high = min(shown), max(shown)
    margin = 0.15 * ((high - low) or 1.0)
    return low - margin, high + margin
