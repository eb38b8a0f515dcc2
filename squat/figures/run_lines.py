"""One line a run: a variable over its coordinate, or over another variable."""

from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd
import xarray as xr
from matplotlib.axes import Axes

from squat import records
from squat.catalogue.telling import differing, named
from squat.errors import InputError
from squat.figures.labels import axis_label
from squat.figures.layers import looks
from squat.quantities import Vector

_NUMBERS = "iuf"  # kinds of types between whose values a line says something
_RING: dict[str, Any] = {"ls": "", "marker": "o", "mfc": "none"}  # a run of one point
_DOT = 3.5  # size of a ring over the width of a line
_MOST = 20  # lines that a reader can still tell apart by legend and dashes


def draw_lines(axes: Axes, table: pd.DataFrame, variable: str, over: str | None) -> str:
    """One line a run, named by what differs between the runs; returns what thick lines mean."""
    if len(table) > _MOST:
        raise InputError(f"runs: {len(table)} lines in one plot; narrow them to {_MOST} by where=")
    labelled = _labelled(table)
    pairs = [_curve(records.read(Path(file)), variable, over) for file, _ in labelled]
    seen = looks([np.stack([_numbers(x), _numbers(y)]) for x, y in pairs])
    for (across, values), (_, label), look in zip(pairs, labelled, seen, strict=True):
        dots = pd.notna(values.values).sum() == 1 or across.dtype.kind not in _NUMBERS
        shown = look | (_RING | {"ms": _DOT * look["lw"]} if dots else {})
        axes.plot(across.values, values.values, label=label, **shown)
        axes.set_xlabel(axis_label(across.attrs["long_name"], across.attrs["units"]))
        axes.set_ylabel(axis_label(values.attrs["long_name"], values.attrs["units"]))
    return "a thick line lies under others" if len({look["lw"] for look in seen}) > 1 else ""


def _curve(data: xr.Dataset, variable: str, over: str | None) -> tuple[xr.DataArray, xr.DataArray]:
    """What `variable` is drawn over, and itself; InputError where it is no line."""
    values = data[variable]
    if values.ndim != 1:
        raise InputError(f"variable={variable}: has {values.ndim} dimensions, not one")
    across = data[over or values.dims[0]]
    if across.dims != values.dims:
        raise InputError(f"over={over}: {variable} runs over {values.dims[0]}; give what does so")
    return across, values


def _numbers(values: xr.DataArray) -> Vector:
    """The values, of names their places."""
    named = values.dtype.kind not in _NUMBERS
    return np.arange(values.size, dtype=float) if named else values.values.astype(float)


def _labelled(table: pd.DataFrame) -> list[tuple[str, str]]:
    """Files with their labels, in the order of the keys that vary."""
    keys, more = differing(table)
    several = len(table["status"].drop_duplicates()) > 1
    labelled = []
    for row in (table.sort_values(keys) if keys else table).to_dict("records"):
        label = named({key: row[key] for key in keys}) + more or Path(row["file"]).stem
        labelled.append((row["file"], f"{label}: {row['status']}" if several else label))
    return labelled
