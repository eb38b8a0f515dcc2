"""Hulls of one draft and displacement: outlines, limits and sinkages side by side."""

import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from squat.figures.style import BLUE, GREEN, ORANGE, RED

_SPEEDS = (
    ("limit_dynamic", "o", RED, "dynamic, from the start"),
    ("limit_2d", "s", BLUE, "2D squat speed"),
    ("limit_local", "D", GREEN, "1D, clearance along the hull"),
)


def hull_shapes(data: xr.Dataset) -> Figure:
    """Outlines, limits, and sinkage at a common current and at the fold; the slowest on top."""
    data = data.sortby("limit_2d")
    rows = np.arange(data.sizes["hull"])
    figure = Figure(figsize=(10.0, 1.6 + 0.5 * len(rows)), layout="constrained")
    panels = figure.subplots(1, 3, sharey=True, width_ratios=(1.0, 1.6, 1.6))
    outlines, speeds, sinkages = panels
    _outlines(outlines, data)
    _speeds(speeds, data, rows)
    _sinkages(sinkages, data, rows)
    outlines.set(yticks=rows, ylim=(len(rows) - 0.5, -0.5))
    outlines.set_yticklabels([_label(data.isel(hull=row)) for row in rows])
    for axes in panels[1:]:
        axes.tick_params(axis="y", length=0)
    handles, labels = [], []
    for axes in panels[1:]:
        found = axes.get_legend_handles_labels()
        handles += found[0]
        labels += found[1]
    figure.legend(handles, labels, loc="outside upper center", ncols=3)
    return figure


def _label(hull: xr.Dataset) -> str:
    name = str(hull["hull"].values).replace("_", " ")
    return f"{name}\n$C_B$ = {float(hull['block_coefficient']):.2f}"


def _outlines(axes: Axes, data: xr.Dataset) -> None:
    """Wetted sections to one scale, each amidships on its row, the water line dotted."""
    lengths = data["waterline_length"].values
    scale = 0.62 / float(data["depth_of_keel"].max())
    for row, length in enumerate(lengths):
        hull = data.isel(hull=row)
        x, z = hull["outline_x"].values, hull["outline_z"].values
        kept = np.isfinite(x)
        level = row - 0.31
        axes.fill(x[kept] - length / 2, level - scale * z[kept], fc="0.85", ec="k", lw=1)
        axes.axhline(level, color=BLUE, lw=0.8, ls=":", zorder=0)
    half = 0.56 * lengths.max()
    axes.set(xlim=(-half, half), xlabel="from amidships [m]")
    axes.set_title("sections, depth stretched", fontsize=10)
    axes.grid(visible=False)


def _speeds(axes: Axes, data: xr.Dataset, rows: np.ndarray) -> None:
    ends = [data[name].values for name, *_ in _SPEEDS]
    axes.hlines(rows, np.min(ends, axis=0), np.max(ends, axis=0), color="0.7", lw=2, zorder=1)
    for name, marker, color, label in _SPEEDS:
        axes.plot(data[name], rows, marker, color=color, ms=6, label=label)
    box = float(data["limit_1d"][0])
    axes.axvline(box, color="k", lw=1, ls="--", label="1D, Eq. (27): the same for all")
    axes.set_xlabel("speed [m/s]")
    axes.set_title("which may go fastest?", fontsize=10)


def _sinkages(axes: Axes, data: xr.Dataset, rows: np.ndarray) -> None:
    current = float(data["current"])
    axes.barh(
        rows, -data["equilibrium"], height=0.45, color=ORANGE, label=f"sinkage at {current:g} m/s"
    )
    axes.plot(-data["sinkage_2d"], rows, "s", color=BLUE, mfc="white", label="sinkage at the fold")
    widest = np.nanmax([-data["sinkage_2d"], -data["equilibrium"]], initial=0)
    axes.set(xlim=(0, 1.07 * widest), xlabel="sinkage $-w$ [m]")
    none = "" if np.isfinite(data["equilibrium"]).any() else f" None floats at {current:g} m/s"
    axes.set_title(f"which sinks least?{none}", fontsize=10)
