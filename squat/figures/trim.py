"""Heave with pitch: equilibria over the current, and what trim costs."""

import numpy as np
import xarray as xr
from matplotlib.figure import Figure

from squat.figures.style import BLUE, GREEN, ORANGE, PURPLE, RED

_LIMITS = (
    ("safe_speed", GREEN, "-", "safe by energy"),
    ("dynamic_limit", RED, "--", "lost in the run"),
    ("heave_only_limit", PURPLE, "-.", "limit of heave alone"),
)


def trim(data: xr.Dataset) -> Figure:
    """Heave and pitch of the equilibria against the current, with fold and limits."""
    figure = Figure(figsize=(6.4, 6.4), layout="constrained")
    panels = figure.subplots(2, 1, sharex=True)
    speed, stable = data["current"].values, data["unstable"].values == 0
    turn = int(np.argmin(stable)) if not stable.all() else len(speed)
    for axes, name, unit in zip(panels, ("heave", "pitch"), (1.0, 180 / np.pi), strict=True):
        values = unit * data[name].values
        axes.plot(speed[:turn], values[:turn], color=BLUE, label="level, stable")
        axes.plot(speed[max(turn - 1, 0) :], values[max(turn - 1, 0) :], "--", color=BLUE,
                  label="level, a mode gives way")  # fmt: skip
        axes.plot(data["trimmed_current"], unit * data[f"trimmed_{name}"], color=ORANGE,
                  label="trimmed, unstable")  # fmt: skip
        for limit, color, style, label in _LIMITS:
            axes.axvline(float(data[limit]), color=color, ls=style, lw=1.2,
                         label=_with_error(data, limit, label))  # fmt: skip
    _mark(data, panels)
    panels[0].set_ylabel("heave $w$ [m]")
    panels[1].set_ylabel("pitch $\\theta$, bow down [°]")
    panels[1].set_xlabel("current relative to the ship $V_\\infty$ [m/s]")
    panels[0].set_xlim(0, 1.05 * float(data["squat_speed"]))
    handles, labels = panels[0].get_legend_handles_labels()
    figure.legend(handles, labels, loc="outside upper center", ncols=2, fontsize=8.5)
    return figure


def _with_error(data: xr.Dataset, limit: str, label: str) -> str:
    """The label with the limit's value, to the digits of its error where that is known."""
    value, error = float(data[limit]), float(data[f"{limit}_error"])
    if not (np.isfinite(error) and error > 0):
        return f"{label}: {value:.3f} m/s"
    digits = max(2, -int(np.floor(np.log10(error))))
    return f"{label}: {value:.{digits}f} ± {error:.{digits}f} m/s"


def _mark(data: xr.Dataset, panels: np.ndarray) -> None:
    """The fold, and the lowest pass at the safe speed."""
    for axes, name, unit in zip(panels, ("heave", "pitch"), (1.0, 180 / np.pi), strict=True):
        fold = {"heave": "squat_sinkage", "pitch": "squat_trim"}[name]
        axes.plot(
            data["squat_speed"],
            unit * data[fold],
            "k.",
            ms=9,
            label=_with_error(data, "squat_speed", "fold"),
        )
        axes.plot(data["safe_speed"], unit * data[f"saddle_{name}"], "o", mfc="none", color=GREEN,
                  label="lowest pass")  # fmt: skip
