"""How fast is safe: limits over speed, over the start, and over the geometry."""

from itertools import cycle

import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator

from squat.errors import InputError
from squat.figures.labels import one_dimensional
from squat.figures.stability import bottom
from squat.figures.style import BLUE, GREEN, ORANGE, PALETTE, PURPLE, RED, single
from squat.quantities import Vector

_LIMITS = (
    ("squat_speed_1d", "1D", ORANGE, 4.0),
    ("squat_speed_2d", "2D", GREEN, 1.5),
    ("dynamic_squat_speed", "dynamic", PURPLE, 1.5),
)
"""Variable, name, colour and width [pt]: the limit that another may lie upon is the widest."""
_LOOPS = [(color, style) for color in ("k", RED) for style in ("-", "--", "-.", ":")]


def limits(data: xr.Dataset) -> Figure:
    """Figure 10 again: 1D and 2D roots, the deepest point reached, and the three limits."""
    figure, axes = single(7.6, 5.0)
    speed = data["speed"].values
    for suffix, style, name in (("_1d", "--", "1D"), ("", "-", "2D")):
        fold = [float(data[f"squat_{what}_{name.lower()}"]) for what in ("speed", "sinkage")]
        for root, color in (("stable", BLUE), ("unstable", RED)):
            line = _up_to(fold, speed, data[f"{root}{suffix}"].values)
            axes.plot(*line, style, color=color, label=f"{name} {root}")
        axes.plot(*fold, "k.", zorder=3)
    start = float(data["start_heave"])
    axes.plot(*_deepest(data), "-.", color="k", lw=1.2, label=f"deepest, released at {start:g} m")
    for name, label, color, width in _LIMITS:
        limit = float(data[name])
        axes.axvline(limit, color=color, lw=width, label=f"{label} limit {limit:.3f} m/s")
    low = bottom(data)
    axes.axhspan(1.055 * low, low, color="0.85", lw=0, label="below the bottom")
    fastest = max(float(data[name]) for name, *_ in _LIMITS)
    axes.set(xlim=(speed[0], min(speed[-1], 1.15 * fastest)), ylim=(1.055 * low, -0.06 * low))
    axes.set_xlabel("current relative to the ship $V_\\infty$ [m/s]")
    axes.set_ylabel("vertical position $w$ [m]")
    axes.set_title(one_dimensional(data), fontsize=9, loc="right")
    figure.legend(loc="outside upper center", ncols=3)
    return figure


def _deepest(data: xr.Dataset) -> tuple[Vector, Vector]:
    """Deepest point over speed, to the dynamic limit where it meets the unstable equilibrium."""
    speed, lowest, end = (data[name].values for name in ("speed", "lowest", "dynamic_squat_speed"))
    known = np.isfinite(lowest)
    fold = [float(data[f"squat_{what}_2d"]) for what in ("speed", "sinkage")]
    there = float(np.interp(end, *_up_to(fold, speed, data["unstable"].values)))
    if not np.isfinite(there) or not known.any() or end < speed[known][-1]:
        return speed, lowest
    return np.append(speed[known], end), np.append(lowest[known], there)


def _up_to(fold: list[float], speed: Vector, root: Vector) -> tuple[Vector, Vector]:
    """A root over speed, with the fold at its end where it ends before the speeds do."""
    known = np.flatnonzero(np.isfinite(root))
    if len(known) == 0 or known[-1] == len(speed) - 1:
        return speed, root
    kept = slice(known[-1] + 1)
    return np.append(speed[kept], fold[0]), np.append(root[kept], fold[1])


def basins(data: xr.Dataset) -> Figure:
    """Dynamic squat speed over w(0) and w'(0): inside a contour that speed is survived."""
    figure, axes = single(7.0, 4.6)
    heave, velocity, grid = _survived(data)
    both = np.r_[-velocity[:0:-1], velocity]
    mirrored = np.hstack([grid[:, :0:-1], grid])
    fastest = float(data["squat_speed_2d"])
    levels = MaxNLocator(14, steps=[1, 2, 5, 10]).tick_values(float(np.nanmin(grid)), fastest)
    shades = axes.contourf(heave, both, mirrored.T, levels, cmap="cividis")
    for n, (color, style) in zip(range(data.sizes["case_speed"]), cycle(_LOOPS), strict=False):
        _basin(axes, data.isel(case_speed=n), color, style)
    _hold(axes, data, heave, both)
    axes.plot(float(data["start_heave"]), float(data["start_velocity"]), "kx", ms=8, label="start")
    figure.colorbar(shades, ax=axes, format="%g", label="dynamic squat speed [m/s]")
    axes.grid(visible=False)
    axes.set_xlabel("$w(0)$ [m]")
    axes.set_ylabel("$\\dot{w}(0)$ [m/s]")
    figure.legend(loc="outside upper center", ncols=4, fontsize=9)
    return figure


def _hold(axes: Axes, data: xr.Dataset, heave: Vector, velocity: Vector) -> None:
    """Axes that hold the map and all separatrices, blank beyond the map, which a title says."""
    loop, edge = data["separatrix_heave"].values, data["separatrix_velocity"].values
    wider = False
    for set_, ends, line in (
        (axes.set_xlim, heave[[0, -1]], loop[np.isfinite(loop)]),
        (axes.set_ylim, velocity[[0, -1]], np.r_[edge, -edge][np.isfinite(np.r_[edge, -edge])]),
    ):
        reach = np.r_[ends, line]
        beyond = np.array([reach.min(), reach.max()]) != ends
        set_(*(reach.min(), reach.max()) + 0.03 * np.ptp(reach) * beyond * [-1, 1])
        wider |= bool(beyond.any())
    if wider:
        axes.set_title("blank: beyond the map", fontsize=9, loc="right")


def _survived(data: xr.Dataset) -> tuple[Vector, Vector, Vector]:
    """The part of the map that some start survives at some speed, and one velocity more.

    Raise InputError where fewer than two of its heaves are between the ground and the top.
    """
    heave, velocity = data["initial_heave"].values, data["initial_velocity"].values
    grid = data["limit_map"].values
    within = np.isfinite(grid).any(axis=1)
    fast = np.flatnonzero((np.nan_to_num(grid) > 0).any(axis=0))
    if within.sum() < 2:
        raise InputError(
            "data: too few w(0) of its map are within reach; give portrait.heaves nearer 0"
        )
    kept = slice(max(fast.max(initial=0), 1) + 2)
    return heave[within], velocity[kept], grid[within][:, kept]


def _basin(axes: Axes, data: xr.Dataset, color: str, style: str) -> None:
    """The separatrix of one current, where it has one."""
    loop, edge = data["separatrix_heave"].values, data["separatrix_velocity"].values
    if not np.isfinite(loop).any():
        return
    for way, label in ((1, f"separatrix at {float(data['case_speed']):g} m/s"), (-1, None)):
        axes.plot(loop, way * edge, color=color, ls=style, lw=1.3, label=label)


def limits_map(data: xr.Dataset) -> Figure:
    """2D and dynamic limits over the 1D value, over H/T for each L/T."""
    figure = Figure(figsize=(9.4, 4.4), layout="constrained")
    left, right = figure.subplots(1, 2, sharey=True)
    ratio = data["depth_over_draft"].values
    for length, color in zip(data["length_over_draft"].values, PALETTE, strict=False):
        row = data.sel(length_over_draft=length)
        for axes, name in ((left, "limit_2d"), (right, "limit_dynamic")):
            share = row[name] / row["limit_1d"]
            axes.plot(ratio, share, "o-", ms=4, color=color, label=f"$L/T$ = {length:g}")
    start = data.attrs["start_over_draft"]
    titles = ("2D squat speed", f"dynamic squat speed, released at $w(0)$ = {start:g} $T$")
    for axes, title in zip((left, right), titles, strict=True):
        axes.axhline(1, color="k", lw=1, ls="--")
        axes.set_title(title, fontsize=10)
        axes.set_xlabel("$H/T$ [-]")
    left.set_ylabel("limit over the 1D squat speed [-]")
    figure.legend(*left.get_legend_handles_labels(), loc="outside right upper")
    return figure
