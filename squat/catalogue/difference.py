"""`squat task=difference`: what two runs do not have in common."""

from pathlib import Path
from typing import Any

import pandas as pd
from pydantic.dataclasses import dataclass

from squat import records
from squat.catalogue.find import find
from squat.quantities import STRICT


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
    """Keys and headline figures in which two runs differ, one row each: key, first, second."""
    pair = find([first]), find([second])
    names = list(dict.fromkeys([*pair[0].columns, *pair[1].columns]))
    rows = []
    for name in names:
        one, other = (frame[name].iloc[0] if name in frame else None for frame in pair)
        both_missing = pd.isna(one) and pd.isna(other)
        if name != "file" and not both_missing and one != other:
            rows.append({"key": name, str(first): one, str(second): other})
    return pd.DataFrame(rows, columns=["key", str(first), str(second)])


def write_difference(case: DifferenceCase, path: Path) -> None:
    """Print the difference, and write it to `path` as CSV."""
    frame = difference(*map(Path, case.runs))
    shown = frame.apply(_short, axis=1, result_type="broadcast")
    print(shown.to_string(index=False, na_rep="-") if len(frame) else "no difference")
    records.save_table(frame, path)


def _short(row: "pd.Series[Any]") -> list[object]:
    """A row with numbers of six digits, or of all where six would make them equal."""
    short = [f"{value:.6g}" if isinstance(value, float) else value for value in row]
    return short if short[1] != short[2] else list(row.astype(str))
