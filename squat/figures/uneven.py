"""A ship over a shelf: loads while the ramp passes, and where one dimension is enough."""

from typing import Any

import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.ticker import FixedLocator, NullLocator

from squat.figures.style import BLUE, GREEN, ORANGE, RED

_STYLES = (("", "-"), ("_1d", "--"), ("_complete", ":"))
_COLORS = (BLUE, ORANGE, GREEN, RED)


def uneven_bottom(data: xr.Dataset) -> Figure:
    """Force and moment over the ramp's place, their error in 1D over the gap, and squat speeds."""
    figure = Figure(figsize=(9.6, 6.6), layout="constrained")
    grid = figure.add_gridspec(3, 2, height_ratios=(0.7, 1.5, 1.5), width_ratios=(1.5, 1))
    _profile(figure.add_subplot(grid[0, 0]), data)
    force = figure.add_subplot(grid[1, 0])
    moment = figure.add_subplot(grid[2, 0], sharex=force)
    square = float(data["current"]) ** 2
    _passing(force, data, "force", "force$/V^2$ [kN s$^2$/m$^3$]", 1e3 * square)
    _passing(moment, data, "moment", "moment$/V^2$, bow down [MN s$^2$/m$^2$]", 1e6 * square)
    force.tick_params(labelbottom=False)
    moment.set_xlabel("place of the ramp's middle, from bow (0) to stern (1), $x/L$")
    _legend(force, data)
    _errors(figure.add_subplot(grid[:2, 1]), data)
    _limits(figure.add_subplot(grid[2, 1]), data)
    return figure


def _profile(axes: Axes, data: xr.Dataset) -> None:
    """Ship and ramps to scale, the ramp's middle under mid-length."""
    length, clearance = float(data["length"]), float(data["clearance"])
    rise = float(data["shelf_rise"])
    keel = [-length / 2, -length / 2, length / 2, length / 2]
    axes.fill(keel, [2.4 * clearance, clearance, clearance, 2.4 * clearance], "0.75", lw=0)
    axes.text(0, 1.7 * clearance, "ship, held", ha="center", va="center", fontsize=8)
    reach = 1.4 * length
    for steepness, color in zip(data["steepness"].values, _COLORS, strict=False):
        half = rise / steepness / 2
        axes.plot([-reach, -half, half, reach], [rise, rise, 0, 0], color=color)
    axes.annotate("", (-0.75 * length, 1.5 * clearance), (-1.2 * length, 1.5 * clearance),
                  arrowprops={"arrowstyle": "->"})  # fmt: skip
    axes.text(-1.2 * length, 1.7 * clearance, "current $V$", va="bottom", fontsize=8)
    axes.set(xlim=(-reach, reach), aspect="equal")
    axes.set_axis_off()


def _passing(axes: Axes, data: xr.Dataset, name: str, label: str, unit: float) -> None:
    place = data["place"].values / float(data["length"])
    for row, color in zip(range(data.sizes["steepness"]), _COLORS, strict=False):
        for suffix, style in _STYLES:
            values = data[f"{name}{suffix}"].values[row] / unit
            axes.plot(place, values, style, color=color, lw=1.5)
    axes.axvspan(0, 1, color="0.93", zorder=0, lw=0)
    axes.set_ylabel(label)


def _legend(axes: Axes, data: xr.Dataset) -> None:
    lines: list[Any] = [
        Line2D([], [], color=color, label=f"steepness {steepness:g}")
        for steepness, color in zip(data["steepness"].values, _COLORS, strict=False)
    ]
    labels = "2D", "1D, local depth", "1D, ends and curvature"
    lines += [
        Line2D([], [], color="k", ls=style, label=label)
        for (_, style), label in zip(_STYLES, labels, strict=True)
    ]
    axes.legend(handles=lines, fontsize=8)


def _errors(axes: Axes, data: xr.Dataset) -> None:
    """Relative error of the 1D loads over gap/length, on the theory's line of slope 1."""
    gap = data["gap_over_length"].values
    for name, color, mark in (("force", BLUE, "o"), ("moment", ORANGE, "s")):
        exact = data[f"slender_{name}"].values
        for suffix, style in _STYLES[1:]:
            error = np.abs(data[f"slender_{name}{suffix}"].values / exact - 1)
            fill = color if suffix == "_1d" else "none"
            axes.loglog(gap, error, style, marker=mark, mfc=fill, color=color,
                        label=f"{name}, {_NAMES[suffix]}")  # fmt: skip
        noise = data[f"slender_{name}_error"].values / np.abs(exact)
        axes.loglog(gap, noise, color="0.6", lw=1, label="error of the 2D values" * (mark == "s"))
    axes.loglog(gap, 4 / np.pi * gap, "k-", lw=0.8, label=r"$4h/(\pi L)$")
    axes.set(xlabel="clearance over length, $h/L$", ylabel="relative error of 1D")
    axes.xaxis.set_major_locator(FixedLocator(gap.tolist()))
    axes.xaxis.set_major_formatter("{x:g}")
    axes.xaxis.set_minor_locator(NullLocator())
    axes.legend(fontsize=8, loc="center left", bbox_to_anchor=(0.0, 0.5))


_NAMES = {"_1d": "local depth", "_complete": "ends and curvature"}


def _limits(axes: Axes, data: xr.Dataset) -> None:
    """Squat speeds over the height of the shelf."""
    share = data["rise"].values / float(data["clearance"])
    for suffix, style in _STYLES:
        axes.plot(share, data[f"squat_speed{suffix}"], style, marker="." * (not suffix), color=BLUE)
    axes.set(xlabel="height of the shelf over the clearance", ylabel="squat speed [m/s]", ylim=0)
