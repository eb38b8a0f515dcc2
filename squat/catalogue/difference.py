"""`squat task=difference`: what two runs do not have in common."""

import json
from pathlib import Path
from typing import Annotated, Any

import pandas as pd
from pydantic import BeforeValidator
from pydantic.dataclasses import dataclass

from squat import records
from squat.catalogue.find import find, places
from squat.catalogue.flat import flatten
from squat.catalogue.select import parts
from squat.errors import InputError
from squat.quantities import STRICT
from squat.records.sweep import SWEEP

_LONGEST = 40
"""Letters of a value that are printed, of a hull's points say."""
_PAIR = 2
_LETTERS = "A", "B"
"""Heads of the two runs' columns as printed."""


def _two(runs: object) -> object:
    if isinstance(runs, str) or (isinstance(runs, (list, tuple)) and len(runs) != _PAIR):
        raise InputError("runs: two files are compared; give runs=[A.nc,B.nc]")
    return runs


@dataclass(frozen=True, kw_only=True, config=STRICT)
class DifferenceCase:
    """Which two runs.

    Parameters
    ----------
    runs
        Two files, or folders that hold one run each.
    """

    runs: Annotated[tuple[str, str], BeforeValidator(_two)]


def difference(first: Path, second: Path) -> pd.DataFrame:
    """Keys and headline figures in which two runs differ, one row each: key, first, second.

    Choices are among the keys, where both files tell them.

    Raises
    ------
    InputError
        A place holds no run, or several.
    """
    pair = _only(first), _only(second)
    names = list(dict.fromkeys([*pair[0].columns, *pair[1].columns]))
    choices = [name for name in parts(pd.concat(pair)) if "." not in name]
    rows = []
    for name in names:
        one, other = (frame[name].iloc[0] if name in frame else None for frame in pair)
        missing = [pd.isna(one), pd.isna(other)]
        untold = all(missing) or (any(missing) and name in choices)
        if name != "file" and not untold and one != other:
            rows.append({"key": name, str(first): one, str(second): other})
    return pd.DataFrame(rows, columns=["key", str(first), str(second)])


def _only(place: Path) -> pd.DataFrame:
    """The row of the one run in `place`."""
    found = find([place])
    if len(found) > 1:
        raise InputError(f"runs={place}: holds {len(found)} runs; give two files")
    run = found.iloc[0]
    return found.assign(**_joined(Path(run["file"]))) if run["kind"] == SWEEP.name else found


def _joined(file: Path) -> dict[str, Any]:
    """What a collected sweep is of: the joined kind, the common keys, values of the swept."""
    dataset = records.read(file)
    axes = json.loads(dataset.attrs["axes"])
    swept = {key: json.dumps(dataset[name].values.tolist()) for name, key in axes.items()}
    joined = json.loads(dataset.attrs["joined"])["schema"].split("/")[1]
    return {"joined": joined, **flatten(json.loads(dataset.attrs["common_config"])), **swept}


def write_difference(case: DifferenceCase, path: Path) -> None:
    """Print the difference, and write it to `path` as CSV."""
    frame = difference(*places(case.runs))
    records.save_table(frame, path)
    if frame.empty:
        print("no difference")
        return
    shown = frame.apply(_short, axis=1, result_type="broadcast")
    for letter, run in zip(_LETTERS, frame.columns[1:], strict=True):
        print(f"{letter}: {run}")  # above the table: paths make its lines too long to read
    print(shown.set_axis(["key", *_LETTERS], axis=1).to_string(index=False))


def _short(row: "pd.Series[Any]") -> list[object]:
    """A row with numbers of six digits and short texts, or all of them where that makes equal."""
    short = [_brief(value) for value in row]
    return short if short[1] != short[2] else list(row.astype(str))


def _brief(value: Any) -> object:
    if pd.isna(value):
        return "-"
    if isinstance(value, float):
        return f"{value:.6g}"
    return f"{value[:_LONGEST]}..." if isinstance(value, str) and len(value) > _LONGEST else value
