"""A ship over a shelf: loads while the ramp passes, and where one dimension is enough."""

from typing import Any

import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.ticker import FixedLocator, NullLocator

from squat.figures.style import BLUE, GREEN, ORANGE, RED, depth_axis, stretch
from squat.quantities import Vector

_STYLES = (("", "-"), ("_1d", "--"), ("_complete", ":"))
_LABELS = {"": "2D", "_1d": "1D, local depth", "_complete": "1D, ends and curvature"}
_WIDE: dict[str, Any] = {
    "lw": 4.0,
    "alpha": 0.4,
}  # of the 2D lines, under those of 1D that may lie on them
_POINTS = {"": "o", "_1d": "x", "_complete": "+"}
_LONGEST = 5.0
"""Width over height of the sketch that is drawn with equal scales, about."""
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
    """Ship and ramps to scale, heights stretched, the ramp's middle under mid-length."""
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
    axes.set_xlim(-reach, reach)
    depth_axis(axes, stretch(2 * reach, 2.4 * clearance, _LONGEST))
    axes.set_axis_off()


def _known(data: xr.Dataset, name: str) -> bool:
    """Whether there is any number of `name` to draw."""
    return bool(np.isfinite(data[name].values).any())


def _alone(suffix: str, values: Vector) -> str | None:
    """The marker of a line of one point, which would not be seen."""
    return _POINTS[suffix] if len(values) == 1 else None


def _passing(axes: Axes, data: xr.Dataset, name: str, label: str, unit: float) -> None:
    place = data["place"].values / float(data["length"])
    for row, color in zip(range(data.sizes["steepness"]), _COLORS, strict=False):
        for suffix, style in _STYLES:
            values = data[f"{name}{suffix}"].values[row] / unit
            wide: dict[str, Any] = {"lw": 1.5} if suffix else _WIDE
            axes.plot(place, values, style, marker=_alone(suffix, place), color=color, **wide)
    axes.axvspan(0, 1, color="0.93", zorder=0, lw=0)
    axes.set_ylabel(label)


def _legend(axes: Axes, data: xr.Dataset) -> None:
    lines: list[Any] = [
        Line2D([], [], color=color, label=f"steepness {steepness:g}")
        for steepness, color in zip(data["steepness"].values, _COLORS, strict=False)
    ]
    lines += [
        Line2D([], [], color="k", ls=style, label=_LABELS[suffix], **({} if suffix else _WIDE))
        for suffix, style in _STYLES
        if _known(data, f"force{suffix}")
    ]
    axes.legend(handles=lines, fontsize=8)


def _errors(axes: Axes, data: xr.Dataset) -> None:
    """Relative error of the 1D loads over gap/length, on the theory's line of slope 1."""
    gap = data["gap_over_length"].values
    for name, color, mark in (("force", BLUE, "o"), ("moment", ORANGE, "s")):
        exact = data[f"slender_{name}"].values
        for suffix, style in _STYLES[1:]:
            if not _known(data, f"slender_{name}{suffix}"):
                continue
            error = np.abs(data[f"slender_{name}{suffix}"].values / exact - 1)
            fill = color if suffix == "_1d" else "none"
            label = f"{name}, {_LABELS[suffix].removeprefix('1D, ')}"
            axes.loglog(gap, error, style, marker=mark, mfc=fill, color=color, label=label)
    _measures(axes, data)
    axes.set(xlabel="clearance over length, $h/L$", ylabel="relative error of 1D")
    axes.xaxis.set_major_locator(FixedLocator(gap.tolist()))
    axes.xaxis.set_major_formatter("{x:g}")
    axes.xaxis.set_minor_locator(NullLocator())
    axes.legend(fontsize=7.5, loc="center left", bbox_to_anchor=(0.0, 0.57))


def _measures(axes: Axes, data: xr.Dataset) -> None:
    """What the errors are measured by: those of the 2D values and the theory's, where lines are."""
    gap = data["gap_over_length"].values
    if len(gap) == 1:
        return
    for name, style in (("force", "-"), ("moment", "-.")):
        if _known(data, f"slender_{name}_error"):
            noise = data[f"slender_{name}_error"].values / np.abs(data[f"slender_{name}"].values)
            axes.loglog(gap, noise, style, color="0.6", lw=1, label=f"{name}, error of 2D itself")
    axes.loglog(gap, 4 / np.pi * gap, "k-", lw=0.8, label=r"$4h/(\pi L)$")


def _limits(axes: Axes, data: xr.Dataset) -> None:
    """Squat speeds over the height of the shelf."""
    share = data["rise"].values / float(data["clearance"])
    for suffix, style in _STYLES:
        if _known(data, f"squat_speed{suffix}"):
            wide: dict[str, Any] = {} if suffix else _WIDE
            axes.plot(share, data[f"squat_speed{suffix}"], style, marker=_alone(suffix, share),
                      color=BLUE, label=_LABELS[suffix], **wide)  # fmt: skip
    axes.set(xlabel="shelf height / clearance at rest [-]", ylabel="squat speed [m/s]")
    axes.set_ylim(0, 1.07 * axes.dataLim.y1)
    axes.legend(fontsize=8, loc="lower left")
