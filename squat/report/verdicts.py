"""The list of verdicts, counted and looked up."""

from collections import Counter
from typing import Any, NamedTuple

import pandas as pd

from squat import published
from squat.analysis.verdict import DIFFERS, INCONSISTENT, MATCH, NOT_RUN
from squat.errors import InputError
from squat.report.contents import Block
from squat.report.tables import Grid

VERDICTS = (MATCH, DIFFERS, INCONSISTENT, NOT_RUN)
Row = dict[str, Any]


class Count(NamedTuple):
    """How many of each verdict."""

    match: int
    differs: int
    inconsistent: int
    not_run: int


def count(verdicts: list[str]) -> Count:
    """Tally of `verdicts`."""
    tally = Counter(verdicts)
    return Count(*(tally[verdict] for verdict in VERDICTS))


def claim_rows(frame: pd.DataFrame, names: tuple[str, ...]) -> list[Row]:
    """Rows of verdicts.csv for the sentences `names` of the paper.

    Raises
    ------
    InputError
        A name is unknown, or its verdict is not in the list.
    """
    claims = published.claims()["claim"]
    rows = {row["claim"]: row for row in frame.to_dict("records")}
    found = []
    for name in names:
        if name not in claims.index:
            raise InputError(f"contents: claims: {name}: unknown; see squat/published/claims.csv")
        if claims[name] not in rows:
            raise InputError(f"verdicts.csv: lacks {name}; write it again with snakemake all")
        found.append({str(key): value for key, value in rows[claims[name]].items()})
    return found


def of_block(block: Block, view: Any) -> list[str]:
    """Verdicts that a block shows."""
    if block.kind == "claims":
        return [row["verdict"] for row in view]
    if isinstance(view, Grid):
        return [cell.verdict for _, cells in view.rows for cell in cells if cell]
    return []
