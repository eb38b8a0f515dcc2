"""`squat task=catalogue`: the table of runs, printed, and kept as parquet."""

from pathlib import Path
from typing import Annotated

from pydantic import Field
from pydantic.dataclasses import dataclass

from squat import records
from squat.catalogue.find import find, places
from squat.catalogue.select import columns, select
from squat.quantities import STRICT

Paths = Annotated[tuple[str, ...], Field(min_length=1)]


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
        Columns to print; empty: kind by kind those that differ. The file has all.
    """

    runs: str | Paths
    where: str
    sort: tuple[str, ...]
    columns: tuple[str, ...]


def write_catalogue(case: CatalogueCase, path: Path) -> None:
    """Print the chosen rows and columns; write the chosen rows with all columns to `path`."""
    frame = select(find(places(case.runs)), case.where, case.sort)
    parts = [frame] if case.columns else [part for _, part in frame.groupby("kind", sort=False)]
    for part in parts:
        shown = columns(part, case.columns)
        print(shown.to_string(index=False, na_rep="-", float_format="{:.6g}".format), end="\n\n")
    print(f"{len(frame)} runs")
    with records.atomic(path) as temporary:
        frame.to_parquet(temporary, index=False)
