"""Chosen runs in one picture: a variable over time, or a headline figure over a key."""

import logging
from pathlib import Path
from typing import Annotated

import matplotlib as mpl
import pandas as pd
from matplotlib.figure import Figure
from pydantic import Field
from pydantic.dataclasses import dataclass

from squat import catalogue
from squat.errors import InputError
from squat.figures.files import save
from squat.figures.lacking import remedy, variables
from squat.figures.run_lines import draw_lines
from squat.figures.run_points import Units, draw_points
from squat.figures.style import SETTINGS, single
from squat.quantities import STRICT

_log = logging.getLogger(__name__)
_USUAL = {"transient": "heave", "piston": "position"}
_LINE = 0.17  # in, height of a line of the legend


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
        held = table[wanted].notna()
        kept = _kept(table, held.all(axis=1), wanted)
        notes = [draw_points(axes, kept, variable, over, units)]
    else:
        names = [variables(file) for file in table["file"]]
        held = pd.DataFrame({name: [name in one for one in names] for name in wanted}, table.index)
        kept = _kept(table, held.all(axis=1), wanted)
        notes = [draw_lines(axes, kept, variable, over)]
    if lacking := len(table) - len(kept):
        missing = " or ".join(name for name in wanted if not held[name].all())
        left_out = f"{lacking} of {len(table)} runs left out: without {missing}"
        _log.warning("%s", left_out)
        notes.append(left_out)
    axes.set_title("\n".join(filter(None, notes)), fontsize=8, loc="right")
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
