"""Figure 10: the roots of Eq. (27) over speed."""

import json

import xarray as xr
from matplotlib.figure import Figure

from squat import published
from squat.figures.style import BLUE, PURPLE, RED, single


def fig10(data: xr.Dataset) -> Figure:
    """Stable, unstable and unphysical root, squat speed, bottom, and the cells of Table 7."""
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
    for cell, (keys, text) in enumerate(published.table("table7")):
        color = BLUE if keys["root"] == "stable" else RED
        label = "" if cell else "Table 7, printed"
        axes.plot(float(keys["V_inf"]), float(text), "o", mfc="none", color=color, label=label)
    axes.plot(squat, sinkage, "k.", ms=9)
    note = f"squat speed {squat:.3f} m/s"
    axes.annotate(
        note, (squat, sinkage), (-10, 0), textcoords="offset points", ha="right", va="center"
    )
    low = float(data["unphysical"].min()) - 1
    axes.axhspan(low, bottom, color="0.85", lw=0)
    axes.text(0.98 * speed[-1], bottom - 0.2, "keel on the bottom or below", ha="right", va="top")
    axes.set(xlim=(speed[0], speed[-1]), ylim=(low, 1.5))
    axes.set_xlabel("current relative to the ship $V_\\infty$ [m/s]")
    axes.set_ylabel("vertical position $w$ [m]")
    figure.legend(loc="outside upper center", ncols=3)
    return figure
