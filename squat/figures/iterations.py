"""Iterations against mass ratio: what the correction buys."""

import numpy as np
import xarray as xr
from matplotlib.figure import Figure
from matplotlib.ticker import NullFormatter, ScalarFormatter

from squat.figures.style import PALETTE, single


def iterations(data: xr.Dataset) -> Figure:
    """Measured points on predicted curves, for the standard and the corrected schemes."""
    figure, axes = single(7.2, 4.6)
    for ratio, color in zip(data["added_mass_ratio"].values, PALETTE, strict=False):
        row = data.sel(added_mass_ratio=ratio)
        label = "standard" if ratio == 0 else f"corrected, $m_{{add}}$ = {ratio:g} $m_f$"
        curve = row["curve_iterations"].where(np.isfinite(row["curve_iterations"]))
        axes.loglog(data["curve_mass_ratio"], curve, color=color, lw=1.2)
        found = row["mean_iterations"].where(np.isfinite(row["mean_iterations"]))
        axes.loglog(data["mass_ratio"], found, "o", ms=5, color=color, label=label)
    axes.axvline(1, color="k", ls=":", lw=1)
    axes.text(1.05, axes.get_ylim()[0], "$m_f = m$", va="bottom")
    ticks = (0.2, 0.5, 1, 2, 5, 10)
    axes.set_xticks(ticks, [f"{tick:g}" for tick in ticks])
    axes.xaxis.set_minor_formatter(NullFormatter())
    axes.yaxis.set_major_formatter(ScalarFormatter())
    axes.set_xlabel("mass ratio $m_f/m$ [-]")
    axes.set_ylabel("structure solves a time step [-]")
    axes.set_title("points: measured mean, none where diverged\nlines: predicted", fontsize=9)
    figure.legend(loc="outside right upper")
    return figure
