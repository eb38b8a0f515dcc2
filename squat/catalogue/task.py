"""`squat task=catalogue`: the table of runs, printed, and kept as parquet."""

import shutil
import sys
from pathlib import Path
from typing import Annotated

import pandas as pd
from pydantic import BeforeValidator, Field
from pydantic.dataclasses import dataclass

from squat import records
from squat.catalogue.find import find, places
from squat.catalogue.select import columns, listed, select
from squat.quantities import STRICT
from squat.sweeps import FAILED

Paths = Annotated[tuple[str, ...], Field(min_length=1)]


def _listed(given: object) -> object:
    return listed(given) if isinstance(given, str) else given


Names = Annotated[tuple[str, ...], BeforeValidator(_listed)]
"""Names of columns; one may stand alone."""


@dataclass(frozen=True, kw_only=True, config=STRICT)
class CatalogueCase:
    """Which runs, and what of them to print.

    Parameters
    ----------
    runs
        Folders and files; folders are searched to any depth.
    where
        A condition in pandas' query language; empty: all runs.
    sort
        Columns to sort by, ``-name`` descending.
    columns
        Columns to print; empty: kind by kind those that differ, as far as the terminal is wide.
        The file has all.
    """

    runs: str | Paths
    where: str
    sort: Names
    columns: Names


def write_catalogue(case: CatalogueCase, path: Path) -> None:
    """Write the chosen rows with all columns to `path`; print them with the chosen columns."""
    searched = places(case.runs)
    frame = select(find(searched), case.where, case.sort)
    parts = [frame] if case.columns else [part for _, part in frame.groupby("kind", sort=False)]
    tables = [columns(part, case.columns) for part in parts if len(part)]
    with records.atomic(path) as temporary:
        frame.to_parquet(temporary, index=False)
    for shown in tables:
        fitting = shown if case.columns or not sys.stdout.isatty() else _fitting(shown)
        print(_text(fitting))
        if left := shown.columns[fitting.shape[1] :].tolist():
            print(f"not shown: {', '.join(left)}")
        print()
    failed = len({note.resolve() for folder in searched for note in folder.rglob(FAILED)})
    unasked = ", whatever where= asks" if case.where else ""
    beside = f"; {_counted(failed, 'job')} failed ({FAILED} in their folders{unasked})"
    print(f"{_counted(len(frame), 'run')}{beside if failed else ''}; {path} has all columns")


def _counted(number: int, what: str) -> str:
    return f"{number} {what}" if number == 1 else f"{number} {what}s"


def _text(frame: pd.DataFrame) -> str:
    told = frame.copy()
    for name in [name for name in frame if frame[name].dtype.kind == "O"]:
        told[name] = frame[name].where(frame[name].notna(), "-")
    return str(told.to_string(index=False, na_rep="-", float_format="{:.6g}".format))


def _fitting(frame: pd.DataFrame) -> pd.DataFrame:
    """The first columns of `frame`, as many as one line of the terminal holds; one at least."""
    width = shutil.get_terminal_size().columns
    counts = range(frame.shape[1], 1, -1)
    fits = (n for n in counts if len(_text(frame.iloc[:, :n]).split("\n", 1)[0]) <= width)
    return frame.iloc[:, : next(fits, 1)]
