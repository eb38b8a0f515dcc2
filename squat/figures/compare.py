"""Chosen runs in one picture: a variable over time, or a headline figure over a key."""

import logging
import textwrap
from collections.abc import Callable
from numbers import Real
from pathlib import Path
from typing import Annotated, Any

import matplotlib as mpl
import numpy as np
import pandas as pd
import xarray as xr
from h5netcdf import File
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from pydantic import Field
from pydantic.dataclasses import dataclass

from squat import catalogue, records
from squat.errors import InputError
from squat.figures.files import save
from squat.figures.labels import named, telling
from squat.figures.lacking import remedy, variables
from squat.figures.layers import looks
from squat.figures.style import CYCLE, SETTINGS, single
from squat.quantities import STRICT, Vector

_log = logging.getLogger(__name__)
_USUAL = {"transient": "heave", "piston": "position"}
Units = Callable[[str, str], str | None]
"""Units of a configured key, by the kind of the run and the key."""
_DONE = ("completed", "converged", "turned")
"""How runs end that have a result; kinds that have no status always do."""
_LINE = 0.17  # in, height of a line of the legend
_WIDE = 42  # letters in a line of an axis label
_NUMBERS = "iuf"  # kinds of types between whose values a line says something
_FIXED = "\N{NO-BREAK SPACE}"
_DOT = 3.5  # size of a ring over the width of a line
_MOST = 20  # lines that a reader can still tell apart by legend and dashes


@dataclass(frozen=True, kw_only=True, config=STRICT)
class CompareCase:
    """Which runs, and what of them to plot.

    Parameters
    ----------
    runs
        Folders and files; folders are searched to any depth.
    where
        A condition in pandas' query language; empty: all runs.
    variable
        A variable with one dimension, or a column of the catalogue; None: heave or position. Runs
        without it are skipped.
    over
        What to plot it over: a variable of that dimension, or a column of the catalogue;
        None: the variable's own coordinate.
    """

    runs: str | Annotated[tuple[str, ...], Field(min_length=1)]
    where: str
    variable: str | None
    over: str | None


def _no_units(kind: str, key: str) -> None:
    """Nobody told."""


def write_compare(case: CompareCase, path: Path, units: Units = _no_units) -> None:
    """Write the picture to `path` (.png) and beside it as .svg."""
    table = catalogue.select(catalogue.find(catalogue.places(case.runs)), case.where)
    if table.empty:
        raise InputError(f"where={case.where}: no run is left; loosen the condition")
    usual = (_USUAL[kind] for kind in table["kind"] if kind in _USUAL)
    variable = case.variable or next(usual, None)
    if variable is None:
        raise InputError("variable=None: runs of this kind have no usual one; give variable=NAME")
    with mpl.rc_context(SETTINGS):
        save(draw(table, variable, case.over, units), path)


def draw(table: pd.DataFrame, variable: str, over: str | None, units: Units = _no_units) -> Figure:
    """The picture of the runs in `table` (of `catalogue.find`) that have what is asked for."""
    figure, axes = single(7.0, 4.0)
    wanted = list(filter(None, (variable, over)))
    if over is not None and set(wanted) <= set(table.columns):
        kept = _kept(table, table[wanted].notna().all(axis=1), wanted)
        _points(axes, kept, variable, over)
        axes.set_xlabel(_column(over, kept, units))
        axes.set_ylabel(_column(variable, kept, units))
    else:
        held = table["file"].map(lambda file: set(wanted) <= set(variables(file)))
        kept = _kept(table, held, wanted)
        _lines(axes, kept, variable, over)
    if lacking := len(table) - len(kept):
        _log.warning("%d of %d runs skipped: without %s", lacking, len(table), " and ".join(wanted))
    if (lines := len(axes.lines)) > 1:
        figure.set_figheight(4.0 + _LINE * lines)
        figure.legend(loc="outside lower center", fontsize=8)
    return figure


def _kept(table: pd.DataFrame, held: "pd.Series[bool]", wanted: list[str]) -> pd.DataFrame:
    """The rows that hold what is wanted; InputError where none does."""
    if held.any():
        return table[held]
    variable, *over = wanted
    raise InputError(remedy(table, variable, over[0] if over else None))


def _lines(axes: Axes, table: pd.DataFrame, variable: str, over: str | None) -> None:
    """One line a run, named by what tells the runs apart."""
    if len(table) > _MOST:
        raise InputError(f"runs: {len(table)} lines in one plot; narrow them to {_MOST} by where=")
    axes.set_prop_cycle(CYCLE)
    labelled = _labelled(table)
    pairs = [_curve(records.read(Path(file)), variable, over) for file, _ in labelled]
    seen = looks([np.stack([_numbers(x), _numbers(y)]) for x, y in pairs])
    for (across, values), (_, label), look in zip(pairs, labelled, seen, strict=True):
        dots = pd.notna(values.values).sum() == 1 or across.dtype.kind not in _NUMBERS
        shown = _ring(look["lw"]) if dots else look
        axes.plot(across.values, values.values, label=label, **shown)
        axes.set_xlabel(_axis(across.attrs["long_name"], across.attrs["units"]))
        axes.set_ylabel(_axis(values.attrs["long_name"], values.attrs["units"]))


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


def _ring(width: float) -> dict[str, Any]:
    """Look of a run of one point, or over names: the larger, the wider its line would be."""
    return {"ls": "", "marker": "o", "mfc": "none", "ms": _DOT * width}


def _points(axes: Axes, table: pd.DataFrame, variable: str, over: str) -> None:
    """A headline figure over a key; a line for each combination of the other keys that vary.

    Over names dots: nothing is between those. Runs that failed are open markers: what they hold
    is the state in which they stopped.
    """
    keys = [
        name for name in telling(_without_synonyms(table, over)) if name not in (variable, over)
    ]
    groups = table.groupby(keys, dropna=False, sort=False) if keys else [((), table)]
    axes.set_prop_cycle(CYCLE)
    between: Any = {} if table[over].map(_is_number).all() else {"ls": ""}
    for values, group in groups:
        label = named(dict(zip(keys, values, strict=True)))
        done = group["status"].isna() | group["status"].isin(_DONE)
        ordered = group[done].sort_values(over)
        shown = label if done.any() else None
        (line,) = axes.plot(
            ordered[over], ordered[variable], marker="o", ms=4, label=shown, **between
        )
        for status, failed in group[~done].groupby("status"):
            name = ": ".join(filter(None, [label, str(status)]))
            look: Any = {"ls": "", "marker": "o", "mfc": "none", "color": line.get_color()}
            axes.plot(failed[over], failed[variable], ms=4, label=name, **look)


def _is_number(value: object) -> bool:
    return isinstance(value, Real) and not isinstance(value, bool)


def _without_synonyms(table: pd.DataFrame, over: str) -> pd.DataFrame:
    """`table` less the choice that `over` is part of, and its other parts, if they tell the same.

    Over `mesh.near`, `mesh=coarse` and `mesh=fine` make one line, not two of a point.
    """
    group = over.partition(".")[0]
    same = [
        name
        for name in table.columns
        if name != over
        and (name == group or name.startswith(f"{group}."))
        and catalogue.implies(table, name, over)
        and catalogue.implies(table, over, name)
    ]
    return table.drop(columns=same)


def _column(name: str, table: pd.DataFrame, units: Units) -> str:
    """A column of the catalogue with its units, where they are known."""
    first = table.iloc[0]
    if name.startswith(catalogue.RESULT):
        with File(first["file"], "r") as file:
            found = catalogue.units(name.removeprefix(catalogue.RESULT), file)
    else:
        found = units(first["kind"], name)
    return name if found is None else _axis(name, found)


def _labelled(table: pd.DataFrame) -> list[tuple[str, str]]:
    """Files with their labels, in the order of the keys that vary."""
    keys = telling(table)
    several = len(table["status"].drop_duplicates()) > 1
    labelled = []
    for row in (table.sort_values(keys) if keys else table).to_dict("records"):
        label = named({key: row[key] for key in keys}) or Path(row["file"]).stem
        labelled.append((row["file"], f"{label}: {row['status']}" if several else label))
    return labelled


def _axis(name: str, units: str) -> str:
    """Label in lines that fit beside the axes, the units whole at its end."""
    unit = "-" if units == "1" else units.replace(" ", _FIXED)
    return textwrap.fill(f"{name} [{unit}]", _WIDE).replace(_FIXED, " ")
