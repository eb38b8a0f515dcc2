"""Read the printed tables, one row a cell."""

from importlib.resources import files
from typing import NamedTuple

import pandas as pd


class Printed(NamedTuple):
    """One printed cell: its keys, and its text as printed (empty for a dash)."""

    keys: dict[str, str]
    text: str


_FILES = {
    1: "table1_piston_parameters.csv",
    2: "table2_iterations.csv",
    3: "table3_iterations_vs_added_mass.csv",
    4: "table4_inertia_coefficient.csv",
    5: "table5_inertia_coefficient.csv",
    6: "table6_coupled_parameters.csv",
    7: "table7_equilibria.csv",
}
_CRITICAL = "critical_inertia_coefficient"
_ROOTS = {"stable_m": "stable", "unstable_m": "unstable"}


def _read(name: str) -> pd.DataFrame:
    with files("squat.published").joinpath(name).open(encoding="utf-8") as file:
        return pd.read_csv(file, dtype=str, keep_default_na=False)


def _melt(frame: pd.DataFrame, key: str, across: str) -> list[Printed]:
    return [
        Printed({key: row[key], across: column}, row[column])
        for row in frame.to_dict("records")
        for column in frame.columns
        if column != key
    ]


def table(number: int) -> list[Printed]:
    """Cells of Table `number`, in the order of the print."""
    frame = _read(_FILES[number])
    match number:
        case 1 | 6:
            return [Printed({"quantity": row[0]}, row[1]) for row in frame.itertuples(index=False)]
        case 2:
            return _melt(frame, "mf_over_m", "scheme")
        case 3:
            return _melt(frame, "madd_over_mf", "mf_over_m")
        case 4:
            return _melt(frame, "depth_over_draft", "source")
        case 5:
            return _melt(frame.drop(columns=_CRITICAL), "a_over_T", "depth_over_draft")
        case _:
            return _melt(frame.rename(columns=_ROOTS), "V_inf", "root")


def critical() -> list[Printed]:
    """Last column of Table 5: 2/(pi a/T), below which the standard scheme would converge."""
    frame = _read(_FILES[5])
    return [Printed({"a_over_T": row["a_over_T"]}, row[_CRITICAL]) for _, row in frame.iterrows()]


def claims() -> pd.DataFrame:
    """Checkable sentences, indexed by id: claim, where, paper, unit."""
    return _read("claims.csv").set_index("id")
