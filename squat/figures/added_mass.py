"""Figures 7 and 9, and the two sensitivity studies of section 3.5."""

import math

import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator, NullFormatter
from matplotlib.tri import Triangulation

from squat import published
from squat.figures import isolines
from squat.figures.style import BLUE, GREEN, PALETTE, RED, depth_axis, single, stretch

_LONGEST = 4.5
"""Width over height of a panel of Fig. 7 that is drawn with equal scales, about."""
_PANEL = 7.6  # width of a panel of Fig. 7, in
_STEPS = [1, 2.5, 4, 5, 10]
"""Between isovalues: of multiples of 2 or 3 some read as others upside down."""
_TITLES = {"surge": "surge", "heave": "heave", "pitch": "pitch (bow down)"}


def fig7(data: xr.Dataset) -> Figure:
    """Pressure p_j of the three rigid modes: solid positive, dashed negative isovalues."""
    grid = Triangulation(data["node_x"], data["node_z"], data["face_node"])
    left, right = _around(np.asarray(grid.x), np.asarray(grid.y))
    depth = float(np.ptp(grid.y))
    high = _PANEL * _times(right - left, depth) * depth / (right - left)
    figure = Figure(figsize=(8.4, 3 * (high + 0.75) + 0.3), layout="constrained")
    panels = figure.subplots(3, 1, sharex=True)
    for axes, mode in zip(panels, _TITLES, strict=True):
        _isovalues(axes, grid, data["pressure"].sel(mode=mode).values, mode)
    panels[-1].set_xlabel("$x$ from the bow [m]")
    return figure


def _times(width: float, depth: float) -> int:
    """How many times to stretch heights [1]: labels need room below the keel."""
    return stretch(width, depth, _LONGEST)


def _isovalues(axes: Axes, grid: Triangulation, pressure: np.ndarray, mode: str) -> None:
    x, z = np.asarray(grid.x), np.asarray(grid.y)
    window = _around(x, z)
    times = _times(window[1] - window[0], float(np.ptp(z)))
    power = 1000 if np.abs(pressure).max() >= 1e6 else 1
    values = pressure / (1000 * power)
    levels = np.asarray(MaxNLocator(9, steps=_STEPS).tick_values(0, np.abs(values).max()))[1:]
    edges = grid.edges[np.flatnonzero(_outer(grid))]
    axes.plot(x[edges].T, z[edges].T, color=BLUE, lw=1.2)
    axes.set_xlim(window)
    drawn: list[tuple[float, np.ndarray]] = []
    for signed, style in ((levels, "solid"), (-levels[::-1], "dashed")):
        lines = axes.tricontour(grid, values, signed, colors="k", linestyles=style, linewidths=0.9)
        pairs = zip(signed.tolist(), lines.allsegs, strict=True)
        drawn += [(level, line) for level, parts in pairs for line in parts if len(line)]
    rim = np.stack([x[edges], z[edges]], axis=-1)
    scale = 72 * _PANEL / (window[1] - window[0]) * np.array([1.0, times])
    isolines.label(axes, drawn, rim, scale)
    depth_axis(axes, times)
    axes.tick_params(labelbottom=True)
    unit = f"{power} " * (power > 1) + ("t/m$^2$" if mode != "pitch" else "t/m")
    axes.set_title(
        f"{_TITLES[mode]}: $p_j$ [{unit}], a pressure of $-p_j\\ddot{{q}}_j$", fontsize=10
    )
    axes.grid(visible=False)


def _around(x: np.ndarray, z: np.ndarray) -> tuple[float, float]:
    """Range of x to show: the hull and two depths on either side, as far as the water goes."""
    surface = np.sort(x[z == z.max()])
    gap = int(np.argmax(np.diff(surface)))
    room = 2 * np.ptp(z)
    return max(x.min(), surface[gap] - room), min(x.max(), surface[gap + 1] + room)


def _outer(grid: Triangulation) -> np.ndarray:
    """Whether each edge belongs to one triangle only."""
    sides = np.sort(grid.triangles[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2), axis=1)
    unique, count = np.unique(sides, axis=0, return_counts=True)
    single_sides = {tuple(side) for side in unique[count == 1].tolist()}
    return np.array([tuple(sorted(edge)) in single_sides for edge in grid.edges.tolist()])


def fig9(data: xr.Dataset) -> Figure:
    """Inertia coefficient over a/T for each H/T, with the print's cells and the criterion."""
    figure, axes = single(7.4, 5.0)
    main = data.isel(cell=np.flatnonzero(data["reading"] == "depth"))
    ratios = np.unique(main["depth_over_draft"])
    colors = [*PALETTE, "#666666", "#999999"]
    for ratio, color in zip(ratios, colors, strict=False):
        row = main.isel(cell=np.flatnonzero(main["depth_over_draft"] == ratio)).sortby("a_over_T")
        axes.plot(
            row["a_over_T"], row["inertia_coefficient"], color=color, label=f"$H/T$ = {ratio:g}"
        )
        for keys, text in published.table("table5"):
            if float(keys["depth_over_draft"]) == ratio:
                axes.plot(float(keys["a_over_T"]), float(text), "o", mfc="none", ms=4, color=color)
    a = np.linspace(float(main["a_over_T"].min()), float(main["a_over_T"].max()), 200)
    axes.plot(a, 2 / (np.pi * a), "k--", lw=1, label="$m_{add} = m$")
    axes.plot([], [], "o", mfc="none", ms=4, color="k", label="Table 5, printed")
    axes.set(
        xlabel="$a/T$, half length over draft [-]", ylabel="inertia coefficient $i$ [-]", ylim=0
    )
    figure.legend(loc="outside right upper")
    return figure


def sensitivity(data: xr.Dataset) -> Figure:
    """Error of the inertia coefficient against mesh size and distance of In and Out."""
    figure = Figure(figsize=(9.0, 4.8), layout="constrained")
    left, right = figure.subplots(1, 2)
    size, distance = data["size"].values, data["distance"].values
    error = np.abs(data["size_inertia_coefficient"].values / float(data["size_limit"]) - 1)
    labels = {
        "fixed": "P1, growth away from the hull kept",
        "scaled": "P1, all sizes in proportion (nodes)",
    }
    for growth, color in zip(data["growth"].values, (BLUE, GREEN), strict=True):
        row = error[data["growth"].values == growth][0]
        left.loglog(size, row, "o-", color=color, label=labels[str(growth)])
    scaled = data["growth"].values == "scaled"
    for nodes, x, y in zip(
        data["size_nodes"].values[scaled][0], size, error[scaled][0], strict=True
    ):
        left.annotate(f"{nodes}", (x, y), (4, -10), textcoords="offset points", fontsize=7)
    left.set(xlabel="element size at the hull [m]", ylabel="relative error of $i$ [-]")
    i = data["distance_inertia_coefficient"].values
    right.loglog(
        distance[:-1],
        np.abs(i / i[-1] - 1)[:-1],
        "o-",
        color=RED,
        label=f"extrapolated, against {distance[-1]:g} m",
    )
    right.set(xlabel="In and Out from bow and stern [m]", ylabel="relative error of $i$ [-]")
    _advise(left, size, data.attrs["recommended_size"], data.attrs["tolerance"])
    _advise(right, distance[:-1], data.attrs["recommended_distance"], data.attrs["tolerance"])
    figure.supxlabel(_recommendation(data), fontsize=10)
    return figure


def _recommendation(data: xr.Dataset) -> str:
    """What keeps the tolerance, either alone, and what both are off together."""
    near, far = data.attrs["recommended_size"], data.attrs["recommended_distance"]
    size = (
        f"{near:g} m at the hull with the growth kept" if math.isfinite(near) else "no size tried"
    )
    distance = f"In and Out {far:g} m away" if math.isfinite(far) else "no distance tried"
    alone = f"{100 * data.attrs['tolerance']:g} % each, alone: {size}, {distance}"
    return (
        f"{alone}; together {100 * _together(data):.1f} %" if math.isfinite(near + far) else alone
    )


def _together(data: xr.Dataset) -> float:
    """Relative error of both recommendations at once: either makes i too small."""
    size = data["size_inertia_coefficient"].sel(growth="fixed", size=data.attrs["recommended_size"])
    distant = data["distance_inertia_coefficient"]
    far = distant.sel(distance=data.attrs["recommended_distance"]) / distant[-1]
    return float(2 - size / data["size_limit"] - far)


def _advise(axes: Axes, ticks: np.ndarray, value: float, tolerance: float) -> None:
    axes.set_xticks(ticks, [f"{tick:g}" for tick in ticks])
    axes.xaxis.set_minor_formatter(NullFormatter())
    axes.axhline(tolerance, color="k", lw=1, ls="--", label=f"{100 * tolerance:g} % accepted")
    if math.isfinite(value):
        axes.axvline(value, color="0.5", lw=1, label=f"recommended: {value:g} m")
    axes.legend(fontsize=8, loc="lower center", bbox_to_anchor=(0.5, 1.0), ncols=2)
