"""Names of several runs: what differs between them, and nothing else."""

import re
import textwrap
from collections.abc import Sequence

import pandas as pd
import xarray as xr
from matplotlib.axes import Axes

from squat import records
from squat.catalogue.flat import row_of
from squat.catalogue.telling import differing, named

_WIDE = 42  # letters in a line of an axis label
_FIXED = "\N{NO-BREAK SPACE}"
_UNIT = re.compile(r"([A-Za-z]+)(-?)(\d*)")
_RAISED = str.maketrans("123456789", "¹²³⁴⁵⁶⁷⁸⁹")
_FAILED = {"diverged": "diverged", "iteration limit": "reached the iteration limit"}


def of_ships(runs: Sequence[xr.Dataset]) -> list[str]:
    """A label for each of the coupled `runs`: what differs, the current where nothing does."""
    table = pd.DataFrame([row_of(run.attrs) for run in runs])
    keys, more = differing(table, "current")
    labels = []
    for row in table[keys or ["current"]].to_dict("records"):
        speed = row.pop("current", None)
        stream = "" if speed is None else f"$V_\\infty$ = {speed:g} m/s"
        rest = named({str(key): value for key, value in row.items()})
        labels.append(", ".join(filter(None, [stream, rest])) + more)
    return labels


def stepless(run: xr.Dataset) -> str:
    """What to say of a run that has its start only; empty: it went on from there."""
    if run.sizes["time"] > 1:
        return ""
    return f"no step was accepted:\nthe first {_FAILED.get(run.attrs['status'], 'failed')}"


def said_in(axes: Axes, text: str) -> None:
    """`text` in the middle of a diagram that has nothing to draw."""
    axes.text(0.5, 0.5, text, transform=axes.transAxes, ha="center", va="center")


def flattened(*runs: xr.Dataset) -> str:
    """What to say where the one-dimensional model and the ground ignore a bottom of `runs`."""
    depths = {
        channel["depth"]
        for channel in (records.config_of(run)["channel"] for run in runs)
        if channel.get("bottom")
    }
    return f"1D and ground: bottom flat at {min(depths):g} m" if depths else ""


def boxed(data: xr.Dataset) -> str:
    """What the one-dimensional model takes the hull of `data` for; empty: for itself."""
    shape = records.config_of(data)["hull"]["shape"]
    return "" if shape == "rectangle" else "a box of this draft"


def one_dimensional(data: xr.Dataset) -> str:
    """What to say where the one-dimensional model is of a simpler hull or bottom than `data`."""
    box = boxed(data)
    return "; ".join(filter(None, [box and f"1D: {box}", flattened(data)]))


def axis_label(name: str, units: str) -> str:
    """Label in lines that fit beside the axes, the units whole at its end."""
    unit = units_label(units).replace(" ", _FIXED)
    return textwrap.fill(f"{name} [{unit}]", _WIDE).replace(_FIXED, " ")


def units_label(units: str) -> str:
    """Units of a dataset as the figures write them: `m s-1` is m/s, `1` a dash."""
    if units == "1":
        return "-"
    parts = [_UNIT.fullmatch(part) for part in units.split()]
    if not all(parts):
        return units
    above = [f"{part[1]}{_power(part[3])}" for part in parts if part and not part[2]]
    below = [f"{part[1]}{_power(part[3])}" for part in parts if part and part[2]]
    over = " ".join(below) if len(below) < 2 else f"({' '.join(below)})"
    return "/".join(filter(None, [" ".join(above) or "1", over]))


def _power(digits: str) -> str:
    return digits.translate(_RAISED).removeprefix("\N{SUPERSCRIPT ONE}")
