"""Names of several runs: what differs between them, and nothing else."""

import textwrap
from collections.abc import Mapping, Sequence

import numpy as np
import pandas as pd
import xarray as xr
from matplotlib.axes import Axes

from squat import catalogue, records
from squat.catalogue.flat import row_of

_LAST = 99  # more dots than any key has
_EXTENT = (
    "time.",
    "snapshots",
    "restart.",
)  # how long and how often: less of a run than what it is
_WIDE = 42  # letters in a line of an axis label
_FIXED = "\N{NO-BREAK SPACE}"
_FAILED = {"diverged": "diverged", "iteration limit": "reached the iteration limit"}


def telling(table: pd.DataFrame, *first: str) -> list[str]:
    """The fewest configured keys that tell apart what all of them do.

    A choice comes before its parts, and the key that names one before what it stands for;
    before all come those that are asked for `first`, at the end those that some runs lack, and
    last how long a run is.
    """
    choices = catalogue.parts(table)

    def place(name: str) -> int:
        if name in first:
            return -1
        if name.startswith(_EXTENT):
            return _LAST + 2
        lacking = table[name].isna().any()
        return name.count(".") if name in choices and not lacking else _LAST + int(lacking)

    kept: list[str] = []
    groups = 1
    for name in sorted(catalogue.varying(table), key=place):
        if name.startswith(catalogue.RESULT):
            continue
        finer = len(table[[*kept, name]].drop_duplicates())
        if finer > groups:
            kept, groups = [*kept, name], finer
    return kept


def named(values: Mapping[str, object]) -> str:
    """Short names of keys with their values, missing ones left out."""
    return ", ".join(
        f"{_short(key)} = " + (f"{value:g}" if isinstance(value, float) else str(value))
        for key, value in values.items()
        if not (isinstance(value, float) and np.isnan(value))
    )


def of_ships(runs: Sequence[xr.Dataset]) -> list[str]:
    """A label for each of the coupled `runs`: what differs, the current where nothing does."""
    table = pd.DataFrame([row_of(run.attrs) for run in runs])
    keys = telling(table, "current") or ["current"]
    labels = []
    for row in table[keys].to_dict("records"):
        speed = row.pop("current", None)
        stream = "" if speed is None else f"$V_\\infty$ = {speed:g} m/s"
        labels.append(", ".join(filter(None, [stream, named({str(k): v for k, v in row.items()})])))
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


def axis_label(name: str, units: str) -> str:
    """Label in lines that fit beside the axes, the units whole at its end."""
    unit = "-" if units == "1" else units.replace(" ", _FIXED)
    return textwrap.fill(f"{name} [{unit}]", _WIDE).replace(_FIXED, " ")


def _short(key: str) -> str:
    """The last word of `key`, of one by which a choice names itself that of the choice."""
    whole = key.rpartition(".")[0] if key.endswith(catalogue.OWN_NAMES) else key
    return whole.rpartition(".")[2]
