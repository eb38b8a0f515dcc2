"""`squat task=difference`: what two runs do not have in common."""

from pathlib import Path
from typing import Any

import pandas as pd
from pydantic.dataclasses import dataclass

from squat import records
from squat.catalogue.find import find
from squat.catalogue.select import parts
from squat.quantities import STRICT

_LONGEST = 40
"""Letters of a value that are printed, of a hull's points say."""


@dataclass(frozen=True, kw_only=True, config=STRICT)
class DifferenceCase:
    """Which two runs.

    Parameters
    ----------
    runs
        Two files.
    """

    runs: tuple[str, str]


def difference(first: Path, second: Path) -> pd.DataFrame:
    """Keys and headline figures in which two runs differ, one row each: key, first, second.

    Choices are among the keys, where both files tell them.
    """
    pair = find([first]), find([second])
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


def write_difference(case: DifferenceCase, path: Path) -> None:
    """Print the difference, and write it to `path` as CSV."""
    frame = difference(*map(Path, case.runs))
    records.save_table(frame, path)
    shown = frame.apply(_short, axis=1, result_type="broadcast")
    print(shown.to_string(index=False, na_rep="-") if len(frame) else "no difference")


def _short(row: "pd.Series[Any]") -> list[object]:
    """A row with numbers of six digits and short texts, or all of them where that makes equal."""
    short = [f"{v:.6g}" if isinstance(v, float) else _cut(v) for v in row]
    return short if short[1] != short[2] else list(row.astype(str))


def _cut(value: object) -> object:
    return f"{value[:_LONGEST]}..." if isinstance(value, str) and len(value) > _LONGEST else value
