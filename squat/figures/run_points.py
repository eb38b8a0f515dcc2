"""A headline figure of each run over a key of its configuration, or over another figure."""

from collections.abc import Callable
from numbers import Real
from typing import Any

import numpy as np
import pandas as pd
from h5netcdf import File
from matplotlib.axes import Axes

from squat import catalogue
from squat.catalogue.telling import differing, named, telling
from squat.figures.labels import axis_label
from squat.figures.layers import looks

_DOT, _MORE = 1.2, 2.0  # size of a dot, pt, and what it grows by with the width of its line
Units = Callable[[str, str], str | None]
"""Units of a configured key, by the kind of the run and the key."""
_STOPPED = {"grounded": "v", "diverged": "X", "iteration limit": "s"}
"""Markers of runs that did not end well, by status; a ring for any other."""
_DONE = ("completed", "converged", "turned")
"""How runs end that have a result; kinds that have no status always do."""


def draw_points(axes: Axes, table: pd.DataFrame, variable: str, over: str, units: Units) -> str:
    """A headline figure over a key; a line for each combination of the other keys that vary.

    Over names dots: nothing is between those. Runs that failed are open markers: what they hold
    is the state in which they stopped. Returns what to say of keys that vary along a line too.
    """
    keys, along = _keys(_without_synonyms(table, over), variable, over)
    groups = table.groupby(keys, dropna=False, sort=False) if keys else [((), table)]
    axes.set_xlabel(_column(over, table, units))
    axes.set_ylabel(_column(variable, table, units))
    numbers = bool(table[over].map(_is_number).all())
    lines = [(named(dict(zip(keys, values, strict=True))), group) for values, group in groups]
    points = np.stack([_places(table[name]) for name in (over, variable)])
    rows = [table.index.get_indexer(group.sort_values(over).index) for _, group in lines]
    seen = looks([points[:, row] for row in rows])
    for (label, group), look in zip(lines, seen, strict=True):
        done = group["status"].isna() | group["status"].isin(_DONE)
        ordered = group[done].sort_values(over)
        shown = label if done.any() else None
        dots: Any = {"marker": "o", "ms": _DOT + _MORE * look["lw"]}
        line = dots | look | ({} if numbers else {"ls": ""})
        axes.plot(ordered[over], ordered[variable], label=shown, **line)
        for status, failed in group[~done].groupby("status"):
            name = ": ".join(filter(None, [label, str(status)]))
            ring = dots | {"ls": "", "mfc": "none", "color": look["color"]}
            ring["marker"] = _STOPPED.get(str(status), "o")
            axes.plot(failed[over], failed[variable], label=name, **ring)
    return f"along a line vary too: {', '.join(along)}" if along else ""


def _keys(table: pd.DataFrame, variable: str, over: str) -> tuple[list[str], list[str]]:
    """Keys that make a line of their own or are one with those; keys that vary along a line."""
    lines = [name for name in telling(table, over) if name not in (variable, over)]
    others = [name for name in differing(table, over)[0] if name not in (variable, over, *lines)]
    count = len(table[lines].drop_duplicates()) if lines else 1
    along = [name for name in others if len(table[[*lines, name]].drop_duplicates()) > count]
    return [*lines, *(name for name in others if name not in along)], along


def _places(column: "pd.Series[Any]") -> "pd.Series[float]":
    """Numbers themselves, of names their places among all of the column."""
    if column.map(_is_number).all():
        return column.astype(float)
    return column.astype(str).rank(method="dense")


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
    shown = _words(name)
    return shown if found is None else axis_label(shown, found)


def _words(name: str) -> str:
    """`heave min` for the figure `result.heave_min`; a key as it is typed."""
    figure = name.removeprefix(catalogue.RESULT)
    return name if figure == name else figure.replace("_", " ")
