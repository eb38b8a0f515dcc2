"""The paper's tables in the paper's shape, each cell with the printed value, ours and a verdict."""

from pathlib import Path
from typing import NamedTuple

import pandas as pd

from squat import published
from squat.analysis.verdict import FEW_DIGITS, MATCH
from squat.errors import InputError

_SHOWN = 5  # significant digits of ours; the CSV has them all

_SYMBOLS = {
    "depth_over_draft": "H/T",
    "a_over_T": "a/T",
    "madd": "m_add",
    "mf_over": "m_f_over",
    "over_mf": "over_m_f",
    "_over_": "/",
    "wendel_1956": "Wendel (1956)",
    "inertia_coefficient": "i",
    "quantity = ": "",
    "wdot0": "w'(0)",
    "w0": "w(0)",
    "steps_per_period": "steps a period",
    "mesh_nodes": "nodes of the mesh",
    "mesh_triangles": "triangles of the mesh",
    "inlet_distance": "distance of In",
    "outlet_distance": "distance of Out",
}


class Cell(NamedTuple):
    """One printed cell: as printed, ours short and in full, how they compare, and why."""

    paper: str
    here: str
    full: str
    verdict: str
    note: str


class Grid(NamedTuple):
    """A table of cells; `corner` names what runs down and across."""

    corner: str
    heads: list[str]
    rows: list[tuple[str, list[Cell | None]]]
    notes: list[tuple[str, str]]
    """Cells that do not match, or by few digits alone, by name, each with its note."""


def read(path: Path) -> pd.DataFrame:
    """A table of `squat task=table` or `task=verdicts` as text.

    Raises
    ------
    InputError
        The file is absent or has no verdicts.
    """
    try:
        frame = pd.read_csv(path, dtype=str, keep_default_na=False)
    except (OSError, ValueError) as error:
        raise InputError(f"{path}: cannot be read; run snakemake all first") from error
    if "verdict" not in frame.columns:
        raise InputError(f"{path}: not a table of squat task=table; write it again")
    return frame


def grid(name: str, frame: pd.DataFrame) -> Grid:
    """The table `name` from the rows of its CSV, laid out as printed."""
    keys = published.layout(name)
    rows = [
        {str(key): str(value) for key, value in row.items()} for row in frame.to_dict("records")
    ]
    cells = {_place(row, keys): _cell(row) for row in rows}
    heads = list(dict.fromkeys(place[1] for place in cells))
    lines = list(dict.fromkeys(place[0] for place in cells))
    units = {line: f" [{unit}]" for line, unit in published.units(name).items()}
    return Grid(
        corner=" \\ ".join(map(symbol, keys)),
        heads=[symbol(head) for head in heads] if len(keys) > 1 else ["printed, ours"],
        rows=[
            (symbol(line) + units.get(line, ""), [cells.get((line, head)) for head in heads])
            for line in lines
        ],
        notes=[
            (symbol(", ".join(filter(None, place))), cell.note)
            for place, cell in cells.items()
            if cell.note and (cell.verdict != MATCH or FEW_DIGITS in cell.note)
        ],
    )


def _place(row: dict[str, str], keys: tuple[str, ...]) -> tuple[str, str]:
    return row[keys[0]], row[keys[1]] if len(keys) > 1 else ""


def _cell(row: dict[str, str]) -> Cell:
    return Cell(row["paper"] or "–", short(row["here"]), row["here"], row["verdict"], row["note"])


def symbol(text: str) -> str:
    """The names of keys in the CSV files as the paper's symbols: ``madd_over_mf`` is m_add/m_f."""
    for plain, printed in _SYMBOLS.items():
        text = text.replace(plain, printed)
    return text


def short(text: str) -> str:
    """A number in few digits; words as they are."""
    try:
        return f"{float(text):.{_SHOWN}g}"
    except ValueError:
        return text
