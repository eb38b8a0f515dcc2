"""Heave with pitch: equilibria over the current, and what trim costs."""

from collections.abc import Iterator
from typing import Any

import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from squat.figures.style import BLUE, GREEN, ORANGE, PURPLE, RED
from squat.quantities import Vector

_ALONE = "limit of heave alone, from the same start,\npitch locked at {start_pitch:.3g} rad"
_LIMITS = (
    ("safe_speed", GREEN, "-", "safe by energy"),
    ("dynamic_limit", RED, "--", "lost in the run"),
    ("heave_only_limit", PURPLE, "-.", _ALONE),
)
_UNITS = {"heave": 1.0, "pitch": 180 / np.pi}
_STABILITY = ("stable", "one direction unstable", "two directions unstable")
_SHORTEST = 0.01  # of the fold's speed: stretches that a reader would look for in vain
_BETWEEN = 8  # parts of the line from one computed point to the next
_BRANCHES: Any = (
    # The wide one lies below: where both are one branch, neither hides the other.
    ("", "from rest", {"color": BLUE, "lw": 1.5, "zorder": 2.2}),
    ("trimmed_", "through the lowest pass", {"color": ORANGE, "lw": 4, "alpha": 0.5, "zorder": 2}),
)


def trim(data: xr.Dataset) -> Figure:
    """Equilibria in heave and pitch over the current: stable or not, their fold, and the limits."""
    figure = Figure(figsize=(7.2, 7.4), layout="constrained")
    panels = dict(zip(_UNITS, figure.subplots(2, 1, sharex=True), strict=True))
    start = {name: float(data[name]) for name in ("start_heave", "start_pitch")}
    for name, axes in panels.items():
        for prefix, branch, look in _BRANCHES:
            _equilibria(axes, data, prefix, name, branch, look)
        for limit, color, style, label in _LIMITS:
            axes.axvline(float(data[limit]), color=color, ls=style, lw=1.2,
                         label=_with_error(data, limit, label.format_map(start)))  # fmt: skip
        _mark(axes, data, name)
    panels["heave"].set_ylabel("heave $w$ [m]")
    panels["pitch"].set_ylabel("pitch $\\theta$, bow down [°]")
    panels["pitch"].set_xlabel("current relative to the ship $V_\\infty$ [m/s]")
    panels["heave"].set_xlim(0, 1.05 * float(data["squat_speed"]))
    handles, labels = panels["heave"].get_legend_handles_labels()
    title = "equilibria, and limits of a ship set free at $w$ = {start_heave:.3g} m, "
    title += "pitch {start_pitch:.3g} rad"
    figure.legend(handles, labels, loc="outside upper center", ncols=2, fontsize=8.5,
                  handlelength=3.2, title=title.format_map(start))  # fmt: skip
    return figure


def _equilibria(
    axes: Axes, data: xr.Dataset, prefix: str, name: str, branch: str, look: dict[str, Any]
) -> None:
    """One branch, its line broken by how many directions are unstable, as the dataset counts."""
    speed, values = data[f"{prefix}current"].values, _UNITS[name] * data[f"{prefix}{name}"].values
    if f"{prefix}unstable" not in data:  # an older dataset
        axes.plot(*filled(speed, values), "-.", label=f"{branch}, stability not recorded", **look)
        return
    drawn = set()
    for count, part in _stretches(_with_fold(data[f"{prefix}unstable"].values, speed)):
        for half in _from_fastest(*filled(speed[part], values[part])):
            short = np.ptp(half[0]) < _SHORTEST * float(data["squat_speed"])
            label = None if short or count in drawn else f"{branch}, {_STABILITY[count]}"
            axes.plot(*half, ("-", "--", ":")[count], label=label, **look)
            drawn |= set() if short else {count}


def filled(speed: Vector, values: Vector) -> tuple[Vector, Vector]:
    """The line through computed points, straight over the square of the current between them.

    So is the squat of slow ships, and the points next to rest are far apart.
    """
    point = np.arange(len(speed))
    between = np.linspace(0, len(speed) - 1, _BETWEEN * (len(speed) - 1) + 1)
    squares = np.interp(between, point, speed**2)
    return np.sqrt(squares), np.asarray(np.interp(between, point, values))


def _from_fastest(speed: Vector, values: Vector) -> Iterator[tuple[Vector, Vector]]:
    """The line as two that begin at its fastest point: mirror images keep step in their dashes."""
    top = int(speed.argmax())
    for half in (slice(top, None), slice(top, None, -1)):
        if len(speed[half]) > 1:
            yield speed[half], values[half]


def _with_fold(counts: Vector, speed: Vector) -> Vector:
    """The counts, that of the fold as on the way to it: one more direction is unstable beyond."""
    fold = int(speed.argmax())
    return np.where(np.arange(len(counts)) == fold, counts[max(fold - 1, 0)], counts)


def _stretches(counts: Vector) -> Iterator[tuple[int, slice]]:
    """Each count with its unbroken stretch of points, and the point before, so that no gap is."""
    ends = [*(np.flatnonzero(np.diff(counts)) + 1).tolist(), len(counts)]
    for begin, end in zip([0, *ends], ends, strict=False):
        if begin < end:
            yield int(counts[begin]), slice(max(begin - 1, 0), end)


def _with_error(data: xr.Dataset, limit: str, label: str) -> str:
    """The label with the limit's value, to the digits of its error where that is known."""
    value, error = float(data[limit]), float(data[f"{limit}_error"])
    if not (np.isfinite(error) and error > 0):
        return f"{label}: {value:.3f} m/s"
    digits = max(2, -int(np.floor(np.log10(error))))
    return f"{label}: {value:.{digits}f} ± {error:.{digits}f} m/s"


def _mark(axes: Axes, data: xr.Dataset, name: str) -> None:
    """The fold, and the lowest pass at the safe speed."""
    fold = {"heave": "squat_sinkage", "pitch": "squat_trim"}[name]
    axes.plot(data["squat_speed"], _UNITS[name] * data[fold], "k.", ms=9, zorder=3,
              label=_with_error(data, "squat_speed", "fold"))  # fmt: skip
    axes.plot(data["safe_speed"], _UNITS[name] * data[f"saddle_{name}"], "o", mfc="none", zorder=3,
              color=GREEN, label="lowest pass")  # fmt: skip
