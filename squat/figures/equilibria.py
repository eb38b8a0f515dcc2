"""Figure 10: the roots of Eq. (27) over speed."""

import json
from typing import Any

import xarray as xr
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from squat import published
from squat.figures.labels import one_dimensional
from squat.figures.style import BLUE, PURPLE, RED, single


def fig10(data: xr.Dataset) -> Figure:
    """Stable, unstable and unphysical root, squat speed and bottom; Table 7 beside its own ship."""
    figure, axes = single()
    config = json.loads(data.attrs["config"])
    bottom = config["hull"]["draft"] - config["channel"]["depth"]
    squat, sinkage = float(data["squat_speed"]), float(data["squat_sinkage"])
    speed = data["speed"].values
    axes.axhline(0, color="k", ls="--", lw=1, label="static position")
    for name, color, label in (
        ("stable", BLUE, "$w_1$, stable"),
        ("unstable", RED, "$w_2$, unstable"),
        ("unphysical", PURPLE, "$w_3$, below the bottom"),
    ):
        axes.plot(speed, data[name], color=color, label=label)
    if _of_the_paper(config):
        _printed(axes)
    axes.plot(squat, sinkage, "k.", ms=9, label=f"squat speed {squat:.3f} m/s")
    low = float(data["unphysical"].min()) + 0.1 * bottom
    axes.axhspan(low, bottom, color="0.85", lw=0)
    axes.text(0.98 * speed[-1], 1.025 * bottom, "keel on the bottom or below", ha="right", va="top")
    axes.set(xlim=(speed[0], speed[-1]), ylim=(low, -0.15 * bottom))
    axes.set_xlabel("current relative to the ship $V_\\infty$ [m/s]")
    axes.set_ylabel("vertical position $w$ [m]")
    axes.set_title(one_dimensional(data), fontsize=9, loc="right")
    figure.legend(loc="outside upper center", ncols=3)
    return figure


def _of_the_paper(config: dict[str, Any]) -> bool:
    """Whether Eq. (27) is that of Table 7: the depth and draft of Table 6, all that it knows."""
    printed = {keys["quantity"]: float(text) for keys, text in published.table("table6")}
    depth, draft = config["channel"]["depth"], config["hull"]["draft"]
    return bool(depth == printed["H"] == printed["H_over_T"] * draft)


def _printed(axes: Axes) -> None:
    """The cells of Table 7."""
    for cell, (keys, text) in enumerate(published.table("table7")):
        color = BLUE if keys["root"] == "stable" else RED
        label = "" if cell else "Table 7, printed"
        axes.plot(float(keys["V_inf"]), float(text), "o", mfc="none", color=color, label=label)
