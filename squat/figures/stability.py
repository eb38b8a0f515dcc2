"""What the energies imply at some currents: potential and phase portraits."""

import json

import numpy as np
import xarray as xr
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from squat.figures.style import BLUE, PALETTE, RED
from squat.quantities import Vector

_FINE = 401  # points of either axis for the curve of the start's energy


def bottom(data: xr.Dataset) -> float:
    """Heave at which a box touches the bottom [m]."""
    config = json.loads(data.attrs["config"])
    return float(config["hull"]["draft"] - config["channel"]["depth"])


def _top(data: xr.Dataset) -> float:
    """Heave up to which to draw [m]: as far as there is data, a third of the clearance at most."""
    start = float(data["start_heave"])
    return min(float(data["heave"][-1]), max(-0.3 * bottom(data), start + 0.1 * abs(start)))


def potential(data: xr.Dataset) -> Figure:
    """U(w) at several currents: the whole, and the wells with the energy of the start."""
    figure = Figure(figsize=(9.6, 4.4), layout="constrained")
    whole, wells = figure.subplots(1, 2)
    low, start = bottom(data), float(data["start_heave"])
    rows = [data.isel(case_speed=n) for n in range(data.sizes["case_speed"])]
    for row, color in zip(rows, PALETTE, strict=False):
        for axes in (whole, wells):
            _curve(axes, row, color)
        level = np.interp(start, row["heave"], _above_rest(row))
        level += (
            np.interp(start, row["heave"], row["inertia"]) * float(row["start_velocity"]) ** 2 / 2e6
        )
        wells.axhline(level, color=color, lw=1, ls=":")
    deepest, highest = _heights(rows)
    room = max(-deepest, 0.02 * highest)
    whole.set(xlim=(low, _top(data)), ylim=(-0.4 * highest, 1.1 * highest))
    wells.set(xlim=(0.8 * low, min(_top(data), -0.15 * low)), ylim=(-1.5 * room, 1.5 * room))
    whole.set_title("the whole curve", fontsize=10)
    wells.set_title("the wells; dotted: energy of the start", fontsize=10)
    wells.axvline(start, color="k", lw=1, ls=":", label=f"$w(0)$ = {start:g} m")
    whole.set_ylabel("$U - U(0)$ [MJ/m]")
    for axes in (whole, wells):
        axes.set_xlabel("heave $w$ [m]")
    if any(_ends(row) for row in rows):
        wells.plot([], [], "o", color="k", label="stable")
        wells.plot([], [], "o", color="k", mfc="white", label="unstable")
    figure.legend(*wells.get_legend_handles_labels(), loc="outside right upper")
    return figure


def _curve(axes: Axes, row: xr.Dataset, color: str) -> None:
    axes.plot(
        row["heave"], _above_rest(row), color=color, label=f"{float(row['case_speed']):g} m/s"
    )
    for (w, height), face in zip(_ends(row), (color, "white"), strict=False):
        axes.plot(w, height, "o", color=color, mfc=face, zorder=3)


def _ends(row: xr.Dataset) -> list[tuple[float, float]]:
    """w [m] and U - U(0) [MJ/m] at the well's bottom and its barrier; empty where there is none."""
    places = [float(row[f"case_{name}"]) for name in ("stable", "unstable")]
    heights = np.interp(places, row["heave"], _above_rest(row)).tolist()
    return [] if np.isnan(places).any() else list(zip(places, heights, strict=True))


def _heights(rows: list[xr.Dataset]) -> tuple[float, float]:
    """Least and greatest U - U(0) [MJ/m] to show: of wells; where none is, around the start."""
    ends = [height for row in rows for _, height in _ends(row)]
    greatest = max(float(_above_rest(row).max()) for row in rows)
    shown = ends or [-greatest, greatest]
    return min(0.0, *shown), max(0.0, *shown)


def _above_rest(row: xr.Dataset) -> np.ndarray:
    """U(w) - U(0) in MJ/m."""
    values = row["potential"].values
    return np.asarray((values - np.interp(0, row["heave"].values, values)) / 1e6)


def phase_portrait(data: xr.Dataset) -> Figure:
    """Curves of constant energy in the plane of w and w', one panel a current."""
    count = data.sizes["case_speed"]
    rows = (count + 1) // 2
    figure = Figure(figsize=(9.0, 3.1 * rows + 0.5), layout="constrained")
    panels = figure.subplots(rows, 2, sharex=True, squeeze=False)
    drawn: dict[str, Artist] = {}
    for n, axes in enumerate(panels.flat):
        if n >= count:
            axes.set_axis_off()
            continue
        _portrait(axes, data.isel(case_speed=n))
        handles, labels = axes.get_legend_handles_labels()
        drawn |= dict(zip(labels, handles, strict=True))
    for axes in panels[-1]:
        axes.set_xlabel("heave $w$ [m]")
    for axes in panels[:, 0]:
        axes.set_ylabel("velocity $\\dot{w}$ [m/s]")
    figure.legend(list(drawn.values()), list(drawn), loc="outside upper center", ncols=5)
    return figure


def _portrait(axes: Axes, data: xr.Dataset) -> None:
    heave, inertia, potential = (data[name].values for name in ("heave", "inertia", "potential"))
    start = float(data["start_heave"]), float(data["start_velocity"])
    own = np.interp(start[0], heave, inertia * start[1] ** 2 / 2 + potential)
    reach, fastest = _reach(potential <= own, heave, start[0]), _fastest(data, own)
    velocity = np.linspace(-fastest, fastest, 161)
    energy = potential + inertia * velocity[:, None] ** 2 / 2
    well, top = (
        np.interp(float(data[f"case_{name}"]), heave, potential) for name in ("stable", "unstable")
    )
    if np.isfinite(top):
        levels = well + (top - well) * np.array([0.1, 0.3, 0.55, 0.8, 1.25, 1.6, 2.1])
        axes.contour(
            heave, velocity, energy, levels, colors="0.7", linewidths=0.8, linestyles="solid"
        )
    _orbit(axes, heave[reach], inertia[reach], potential[reach] - own, fastest)
    axes.plot(*start, "x", color=BLUE, ms=5, mew=1, label="start")
    if np.isfinite(top):
        _well(axes, data)
    axes.set(xlim=(bottom(data), _top(data)), ylim=(-fastest, fastest))
    speed = float(data["case_speed"])
    limit = float(data["dynamic_squat_speed"])
    end = "is lost" if speed >= limit else "turns"
    axes.set_title(f"$V_\\infty$ = {speed:g} m/s: the start {end}", fontsize=10)


def _orbit(axes: Axes, heave: Vector, inertia: Vector, above: Vector, fastest: float) -> None:
    """The curve of the start's energy, fine and on top, as it may be no larger than a marker.

    `above` (n,) [J/m] is the potential less that energy, `fastest` [m/s] the last to be drawn.
    """
    fine = np.linspace(heave[0], heave[-1], _FINE)
    mass, rise = (np.interp(fine, heave, values) for values in (inertia, above))
    top = min(fastest, 1.1 * float(np.sqrt(2 * np.maximum(-rise, 0) / mass).max()))
    velocity = np.linspace(-top, top, _FINE) if top > 0 else np.array([-fastest, fastest])
    energy = rise + mass * velocity[:, None] ** 2 / 2
    axes.contour(fine, velocity, energy, [0.0], colors=BLUE, linewidths=1.4, linestyles="solid",
                 zorder=4)  # fmt: skip
    axes.plot([], [], color=BLUE, lw=1.4, label="energy of the start")


def _fastest(data: xr.Dataset, own: float) -> float:
    """Velocity [m/s] up to which to draw: of the separatrix and of the start's energy `own`.

    Of the latter above the equilibrium alone where there is one; a ship without is followed down.
    """
    heave, edge = data["heave"].values, data["separatrix_velocity"].values
    lift = np.maximum(2 * (own - data["potential"].values) / data["inertia"].values, 0)
    stable = float(data["case_stable"])
    lift = np.where(np.isnan(stable) | (heave > stable), lift, 0)
    return 1.15 * float(max(np.nanmax(edge, initial=0), np.sqrt(lift.max()))) or 0.1


def _well(axes: Axes, data: xr.Dataset) -> None:
    """The separatrix, the equilibrium within and the barrier on it."""
    loop, edge = data["separatrix_heave"].values, data["separatrix_velocity"].values
    for way, label in ((1, "separatrix"), (-1, None)):
        axes.plot(loop, way * edge, color=RED, lw=1.8, label=label)
    axes.plot(float(data["case_stable"]), 0, "ko", ms=2.5, label="stable")
    axes.plot(float(data["case_unstable"]), 0, "ko", ms=5, mfc="white", label="unstable")


def _reach(admitted: np.ndarray, heave: np.ndarray, start: float) -> slice:
    """The positions that the energy admits without a gap from `start`, and one more either way."""
    inside, outside = np.flatnonzero(admitted), np.flatnonzero(~admitted)
    here = inside[np.abs(heave[inside] - start).argmin()]
    low = outside[outside < here].max(initial=0)
    return slice(low, outside[outside > here].min(initial=len(heave) - 1) + 1)
