"""Read the printed tables, one row a cell."""

from importlib.resources import files
from typing import NamedTuple

import pandas as pd


class Printed(NamedTuple):
    """One printed cell: its keys, and its text as printed (empty for a dash)."""

    keys: dict[str, str]
    text: str


_FILES = {
    "table1": "table1_piston_parameters.csv",
    "table2": "table2_iterations.csv",
    "table3": "table3_iterations_vs_added_mass.csv",
    "table4": "table4_inertia_coefficient.csv",
    "table5": "table5_inertia_coefficient.csv",
    "table6": "table6_coupled_parameters.csv",
    "table7": "table7_equilibria.csv",
}
_ACROSS = {
    "table2": ("mf_over_m", "scheme"),
    "table3": ("madd_over_mf", "mf_over_m"),
    "table4": ("depth_over_draft", "source"),
    "table5": ("a_over_T", "depth_over_draft"),
    "table7": ("V_inf", "root"),
}
"""Tables with two keys: the one down the page, the one across."""
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


def table(name: str) -> list[Printed]:
    """Cells of a table (`table1`, ..., `table5_critical`), in the order of the print."""
    if name == "table5_critical":
        rows = _read(_FILES["table5"]).to_dict("records")
        return [Printed({"a_over_T": row["a_over_T"]}, row[_CRITICAL]) for row in rows]
    frame = _read(_FILES[name])
    if name in _ACROSS:
        key, across = _ACROSS[name]
        columns = [column for column in frame.columns if column != _CRITICAL]
        return _melt(frame[columns].rename(columns=_ROOTS), key, across)
    return [Printed({"quantity": row[0]}, row[1]) for row in frame.itertuples(index=False)]


def units(name: str) -> dict[str, str]:
    """Units of a table's quantities, those with one; empty for tables of one quantity."""
    frame = _read(_FILES[name]) if name in _FILES else pd.DataFrame()
    if "unit" not in frame:
        return {}
    return {row["quantity"]: row["unit"] for _, row in frame.iterrows() if row["unit"] != "1"}


def layout(name: str) -> tuple[str, ...]:
    """Keys of a table: the one down the page, and the one across where there is one."""
    return _ACROSS.get(name) or tuple(table(name)[0].keys)


def claims() -> pd.DataFrame:
    """Checkable sentences, indexed by id: claim, where, paper, unit."""
    return _read("claims.csv").set_index("id")
