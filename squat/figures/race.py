"""The race: iterations a step over mass ratio, time step, scheme and accelerator."""

from itertools import cycle
from typing import Any

import numpy as np
import xarray as xr
from matplotlib import colormaps
from matplotlib.axes import Axes
from matplotlib.colors import BoundaryNorm, Colormap, to_rgb
from matplotlib.figure import Figure
from matplotlib.ticker import NullFormatter, ScalarFormatter

from squat.figures.style import PALETTE
from squat.quantities import Vector

_TABLES = (
    ("piston", "newmark", "Piston in the U-tube (the water restores), Newmark"),
    ("sprung", "newmark", "Piston on a spring (the structure restores), Newmark"),
    ("ship", "newmark", "Ship in heave, Newmark and second-order backward $d\\phi/dt$"),
    ("ship", "centred", "Ship in heave, centred as in Algorithm 2"),
)
_LIMITS = (1, 2.5, 3.5, 5.5, 10.5, 20.5, 50.5, 200)
_LOST = "#bbbbbb"


def race(data: xr.Dataset) -> Figure:
    """Tables of iterations with |G| above each block, and the sweep of wrong added masses below."""
    heights = [0.17 * len(_labels(data)) * len(_TABLES) + 3.4, 3.4]
    figure = Figure(figsize=(11.5, sum(heights)), layout="constrained")
    grid = figure.add_gridspec(2, 1, height_ratios=heights)
    upper, lower = (figure.add_subfigure(part) for part in (grid[0], grid[1]))
    panels = upper.subplots(len(_TABLES), 1)
    for axes, (problem, integrator, title) in zip(panels, _TABLES, strict=True):
        _table(axes, data.sel(problem=problem, integrator=integrator))
        axes.set_title(title, fontsize=10, loc="left", pad=20)
    panels[-1].set_xlabel("mass ratio, water's inertia over the structure's [-]")
    upper.suptitle("structure solves a step; -: diverged, or over the limit", fontsize=11)
    problems = [str(name) for name in data["problem"].values]
    sweeps = lower.subplots(1, len(problems), sharey=True, squeeze=False)[0]
    for axes, name in zip(sweeps, problems, strict=True):
        _sweep(axes, data.sel(problem=name))
        axes.set_title(name, fontsize=10)
    sweeps[0].set_ylabel("structure solves a step [-]")
    at = f"mass ratio {data.attrs['factor_mass_ratio']:g}, {data.attrs['factor_steps']} steps"
    gap = "a gap: diverged, or over the limit"
    lower.suptitle(f"$m_{{add}}$ wrong by a factor ({at} a period); {gap}", fontsize=10)
    lower.legend(*sweeps[0].get_legend_handles_labels(), loc="outside right center", fontsize=8)
    return figure


def _labels(data: xr.Dataset) -> list[str]:
    names = [str(name) for name in data["accelerator"].values]
    blocks = [[f"{scheme}: |G|", *names] for scheme in data["scheme"].values]
    return [label for block in blocks for label in block]


def _table(axes: Axes, data: xr.Dataset) -> None:
    """One block of rows a scheme: |G|, then an accelerator each; columns by time step."""
    counts = _columns(data["mean_iterations"])
    factors = np.abs(_columns(data["predicted_contraction"]))
    norm = BoundaryNorm(_LIMITS, 256)
    colours = colormaps["cividis_r"].with_extremes(bad=_LOST)
    labels, height = _labels(data), 1 + counts.shape[1]
    grid = np.full((len(labels), counts.shape[-1]), np.nan)
    for block, (row, factor) in enumerate(zip(counts, factors, strict=True)):
        top = block * height
        grid[top + 1 : top + height] = row
        for column, value in enumerate(factor):
            weight = "bold" if value >= 1 else "normal"
            axes.text(column, top, _short(value), fontweight=weight, **_CENTRED)
    axes.imshow(np.ma.masked_invalid(grid), cmap=colours, norm=norm, aspect="auto")
    for top in range(0, len(labels), height):
        axes.axhspan(top - 0.5, top + 0.5, color="white", zorder=1)
    for (line, column), value in np.ndenumerate(grid):
        if line % height:
            _cell(axes, column, line, value, colours, norm)
    _frame(axes, data, labels)


_CENTRED: dict[str, Any] = {"ha": "center", "va": "center", "fontsize": 6.5, "zorder": 3}


def _columns(values: xr.DataArray) -> Vector:
    """(scheme, ..., columns), the columns by steps a period and then mass ratio."""
    flat = values.stack(column=("steps_per_period", "mass_ratio"))
    return np.asarray(flat.transpose("scheme", ..., "column").values, float)


def _cell(
    axes: Axes, column: int, line: int, value: float, colours: Colormap, norm: BoundaryNorm
) -> None:
    lost = bool(np.isnan(value))
    background = to_rgb(_LOST) if lost else colours(norm(value))[:3]
    ink = "black" if np.dot(background, (0.3, 0.6, 0.1)) > 0.45 else "white"
    axes.text(column, line, "-" if lost else _short(value), color=ink, **_CENTRED)


def _short(value: float) -> str:
    if value < 1e-2:
        return "0" if value < 1e-12 else f"{value:.0e}".replace("e-0", "e-")
    return f"{value:.2f}" if value < 1 else f"{value:.1f}" if value < 9.95 else f"{value:.0f}"


def _frame(axes: Axes, data: xr.Dataset, labels: list[str]) -> None:
    """Labels of rows and columns, lines between the time steps."""
    ratios, steps = data["mass_ratio"].values, data["steps_per_period"].values
    axes.grid(visible=False)
    axes.set_yticks(range(len(labels)), labels, fontsize=7)
    axes.set_xticks(range(len(ratios) * len(steps)), [f"{r:g}" for r in ratios] * len(steps))
    axes.tick_params(axis="x", labelsize=7, length=2)
    axes.tick_params(axis="y", length=0)
    for tick in axes.get_yticklabels():
        if "|G|" in tick.get_text():
            tick.set_fontweight("bold")
    for group, count in enumerate(steps):
        left = group * len(ratios)
        axes.text(
            left + (len(ratios) - 1) / 2, -0.8, f"{count} steps a period", ha="center", fontsize=8
        )
        if group:
            axes.axvline(left - 0.5, color="black", lw=1.2, zorder=4)


def _sweep(axes: Axes, data: xr.Dataset) -> None:
    """Iterations of every accelerator over the factor; |G| < 1 shaded."""
    factor = data["factor"].values
    shown = factor > 0
    # One degree of freedom makes some coincide: the later ones are thinner and dashed.
    styles = cycle([("o-", 4.5, 2.4), ("s--", 3.0, 1.2)])
    names = data["accelerator"].values
    for name, color, (style, size, width) in zip(names, PALETTE, styles, strict=False):
        count = data["factor_iterations"].sel(accelerator=name).values[shown]
        axes.loglog(factor[shown], count, style, ms=size, lw=width, color=color, label=str(name))
    stable = factor[shown & (np.abs(data["factor_predicted_contraction"].values) < 1)]
    axes.axvspan(stable.min(), stable.max(), color="0.93", zorder=0, label="|G| < 1")
    axes.set_xlabel("$m_{add}/(\\beta c)$ [-]")
    axes.set_xticks([0.1, 1, 10], ["0.1", "1", "10"])
    axes.xaxis.set_minor_formatter(NullFormatter())
    axes.yaxis.set_major_formatter(ScalarFormatter())
