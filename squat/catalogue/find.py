"""Runs are found by what their files say of themselves, not by where they lie."""

import gc
import logging
import os
from collections.abc import Iterable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any

import pandas as pd
from h5netcdf import File

from squat.catalogue.flat import row_of
from squat.catalogue.headlines import headline
from squat.errors import InputError
from squat.records.files import quiet
from squat.records.intact import intact
from squat.sweeps import FAILED

RESULT = "result."
"""What the names of headline figures begin with."""
_log = logging.getLogger(__name__)
FIXED = ["file", "kind", "status"]
"""Columns that every run has; `status` is missing where a kind has none."""


def find(places: Iterable[Path]) -> pd.DataFrame:
    """One row for every file of squat's in `places` (files, or folders searched to any depth).

    Columns are `FIXED`, the choices by their groups and the configuration under dotted keys, then
    the headline figures under ``result.``. NetCDF files of others are passed over, broken ones
    named in a warning.

    Raises
    ------
    InputError
        A place does not exist, or holds no run.
    """
    places = list(places)
    broken: dict[Path, str] = {}
    rows = [row for path in files(places) if (row := _row(path, broken)) is not None]
    if not rows:
        raise InputError(_nothing(places, broken))
    for path, error in broken.items():
        _log.warning("%s: passed over, not readable (%s)", path, error)
    frame = pd.DataFrame(rows)
    rest = sorted(frame.columns.drop(FIXED), key=lambda name: name.startswith(RESULT))
    return frame[[*FIXED, *rest]]


def _nothing(places: Sequence[Path], broken: Mapping[Path, str]) -> str:
    """Why `places` hold no run, and the remedy."""
    names = ", ".join(map(str, places))
    path, error = next(iter(broken.items()), (None, ""))
    if failed := sum(1 for place in places for _ in place.rglob(FAILED)):
        return f"runs={names}: holds no run, {failed} jobs failed ({FAILED} in their folders)"
    if path is None:
        return f"runs={names}: holds no run; give a folder with files of squat"
    if path in places:
        return f"runs={path}: not readable ({error}); write it again"
    return f"runs={names}: holds no whole run ({path}: {error}); write it again"


def places(runs: str | Sequence[str]) -> list[Path]:
    """`runs` as paths; InputError for an empty name, which would be the folder one is in."""
    names = [runs] if isinstance(runs, str) else list(runs)
    if not all(names):
        raise InputError("runs: a name is empty; give folders or files, '.' for this folder")
    return [Path(name) for name in names]


def files(places: Iterable[Path]) -> Iterator[Path]:
    """NetCDF files in `places`, those that are hidden, or in hidden folders, left out."""
    for place in places:
        if not place.exists():
            raise InputError(f"runs={place}: no such file or folder; give where the runs lie")
        if place.is_file():
            yield place
        else:
            yield from sorted(_below(place))


def _below(folder: Path) -> Iterator[Path]:
    for root, folders, names in os.walk(folder):
        folders[:] = [name for name in folders if not name.startswith(".")]
        yield from (Path(root, n) for n in names if n.endswith(".nc") and not n.startswith("."))


def _row(path: Path, broken: dict[Path, str]) -> dict[str, Any] | None:
    """What `path` says of itself; None for a file of others, or one that is put into `broken`."""
    with quiet():
        row = _read(path, broken)
        if row is None:
            gc.collect()  # a file that failed to open, while it is kept quiet
    return row


def _read(path: Path, broken: dict[Path, str]) -> dict[str, Any] | None:
    try:
        if not intact(path):
            broken[path] = "altered since it was written"
            return None
        with File(path, "r") as file:
            parts = str(file.attrs.get("schema", "")).split("/")
            if parts[0] != "squat" or len(parts) != 3 or "config" not in file.attrs:
                return None
            config = row_of(file.attrs)
            row = {"file": str(path), "kind": parts[1], "status": file.attrs.get("status")}
            figures = {f"{RESULT}{key}": n for key, n in headline(parts[1], file).items()}
            return {**row, **config, **figures}
    except (OSError, ValueError, KeyError) as error:
        broken[path] = type(error).__name__
    return None
