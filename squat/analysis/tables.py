"""The paper's tables, one row a printed cell."""

import math
from pathlib import Path
from typing import Any, Literal

import pandas as pd
import xarray as xr
from pydantic.dataclasses import dataclass

from squat import published, records
from squat.analysis import equilibria_tables, inertia_tables, piston_tables
from squat.analysis.lookup import Here, Reader
from squat.analysis.verdict import (
    DIFFERS,
    FEW_DIGITS,
    INCONSISTENT,
    MATCH,
    Verdict,
    difference,
    judge,
)
from squat.errors import InputError
from squat.quantities import STRICT
from squat.records.added_mass_kinds import ADDED_MASS, INERTIA
from squat.records.piston_kinds import ITERATIONS
from squat.records.schema import Kind
from squat.records.stability_kinds import EQUILIBRIA

Name = Literal[
    "table1", "table2", "table3", "table4", "table5", "table5_critical", "table6", "table7"
]
TABLES: dict[str, tuple[Kind, Reader]] = {
    "table1": (ITERATIONS, piston_tables.table1),
    "table2": (ITERATIONS, piston_tables.table2),
    "table3": (ITERATIONS, piston_tables.table3),
    "table4": (INERTIA, inertia_tables.table4),
    "table5": (INERTIA, inertia_tables.table5),
    "table5_critical": (INERTIA, inertia_tables.table5_critical),
    "table6": (ADDED_MASS, inertia_tables.table6),
    "table7": (EQUILIBRIA, equilibria_tables.table7),
}


_TELLING = 0.05
"""Difference over value beyond which a match owes itself to the few digits of the print."""


@dataclass(frozen=True, kw_only=True, config=STRICT)
class TableCase:
    """Which table, from which dataset.

    Parameters
    ----------
    name
        `table1` to `table7`, or `table5_critical` for the last column of Table 5.
    data
        Path of the dataset that holds our values.
    """

    name: Name
    data: str


def compare(name: str, data: xr.Dataset) -> pd.DataFrame:
    """One table: keys, paper, here, difference, verdict, note; cells not run are left out."""
    look_up = TABLES[name][1](data)
    rows: list[dict[str, Any]] = []
    for keys, text in published.table(name):
        here = look_up(keys)
        if math.isnan(here.value):
            continue
        if name in ("table4", "table5"):
            here = inertia_tables.with_mesh(text, here)
        verdict: Verdict = judge(text, here.value, rounds_down=here.rounds_down)
        if verdict == DIFFERS and here.inconsistent:
            verdict = INCONSISTENT
        apart = difference(text, here.value)
        remark = _rounding(text, here) if verdict == DIFFERS else _coarse(text, here, apart)
        note = "; ".join(filter(None, [here.note, remark]))
        rows.append(
            {
                **keys,
                "paper": text,
                "here": f"{here.value:.12g}",
                "difference": "" if math.isnan(apart) else f"{apart:.6g}",
                "verdict": verdict,
                "note": note,
                **here.columns,
            }
        )
    return pd.DataFrame(rows)


def _rounding(text: str, here: Here) -> str:
    """Whether the print is our value after all, cut off where others are rounded or reversed."""
    if here.explained or judge(text, here.value, rounds_down=not here.rounds_down) != MATCH:
        return ""
    how = ("cut off", "rounded") if not here.rounds_down else ("rounded", "cut off")
    return f"printed {how[0]}, where other cells are {how[1]}"


def _coarse(text: str, here: Here, apart: float) -> str:
    """That a match says little, where the print has so few digits."""
    if here.rounds_down or not math.isfinite(apart) or abs(apart) <= _TELLING * abs(here.value):
        return ""
    return f"{FEW_DIGITS}, {abs(apart / here.value):.0%} of ours apart"


def write_table(case: TableCase, path: Path) -> None:
    """Write one table as CSV."""
    frame = compare(case.name, records.read(Path(case.data), TABLES[case.name][0]))
    if frame.empty:
        raise InputError(f"data={case.data}: holds no cell of {case.name}; run the paper's cases")
    records.save_table(frame, path)
