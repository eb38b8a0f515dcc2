"""One list of everything that the paper says and that can be checked."""

from pathlib import Path
from typing import Annotated, Any

import pandas as pd
from pydantic import Field
from pydantic.dataclasses import dataclass

from squat import published, records
from squat.analysis import (  # noqa: F401  (register their checks)
    inertia_claims,
    prospect_claims,
    stability_claims,
    transient_claims,
)
from squat.analysis.claims import CHECKS, Check, Finding, Sources
from squat.analysis.tables import TABLES
from squat.analysis.verdict import NOT_RUN, Verdict, judge
from squat.errors import InputError
from squat.quantities import STRICT
from squat.records.added_mass_kinds import ADDED_MASS, INERTIA
from squat.records.piston_kinds import ITERATIONS
from squat.records.stability_kinds import EQUILIBRIA, LIMITS
from squat.records.transient_kinds import TRANSIENT
from squat.records.trim_kinds import TRIM

COLUMNS = ["claim", "where", "paper", "here", "unit", "verdict", "note"]
_TABLE_COLUMNS = ("paper", "here", "difference", "verdict", "note")
_UNITS = {"table7": "m"}
"""Of tables of one quantity; those not named have no dimension."""
_KEYS = {key for name in TABLES for cell in published.table(name) for key in cell.keys}


@dataclass(frozen=True, kw_only=True, config=STRICT)
class VerdictsCase:
    """Where the evidence lies.

    Parameters
    ----------
    tables
        CSV files of task=table.
    iterations, equilibria
        Datasets of those tasks.
    table4, table5
        Datasets of task=inertia.
    table6
        Dataset of task=added_mass.
    limits
        Dataset of task=limits.
    trim
        Dataset of task=trim.
    transients
        Datasets of task=transient, in heave alone.
    pitching
        Datasets of task=transient, in heave and pitch.
    """

    tables: Annotated[tuple[str, ...], Field(min_length=1)]
    iterations: str
    equilibria: str
    table4: str
    table5: str
    table6: str
    limits: str
    trim: str
    transients: Annotated[tuple[str, ...], Field(min_length=1)]
    pitching: Annotated[tuple[str, ...], Field(min_length=1)]


def table_rows(path: Path) -> list[dict[str, Any]]:
    """Rows of the list from one table's CSV."""
    try:
        frame = pd.read_csv(path, dtype=str, keep_default_na=False)
        keys = [column for column in frame.columns if column in _KEYS]
        first = frame[[keys[0], *_TABLE_COLUMNS]].columns[0]
    except (OSError, ValueError, KeyError, IndexError) as error:
        raise InputError(f"{path}: not a table of squat task=table; write it again") from error
    units = published.units(path.stem)
    where = path.stem.replace("table", "Table ").replace("_critical", ", last column")
    return [
        {
            "claim": where + ": " + ", ".join(f"{key} = {row[key]}" for key in keys),
            "where": where,
            **{name: row[name] for name in ("paper", "here", "verdict", "note")},
            "unit": units.get(row[first], _UNITS.get(path.stem, "1")),
        }
        for row in frame.to_dict("records")
    ]


def claim_rows(sources: Sources) -> list[dict[str, Any]]:
    """Rows of the list from the paper's sentences."""
    rows = []
    for name, sentence in published.claims().iterrows():
        found = _found(CHECKS[str(name)], sources)
        here = found.here if isinstance(found.here, str) else f"{found.here:.12g}"
        rows.append(
            {
                **{key: sentence[key] for key in ("claim", "where", "paper", "unit")},
                "here": here,
                "verdict": _verdict(sentence["paper"], found),
                "note": found.note,
            }
        )
    return rows


def _found(check: Check, sources: Sources) -> Finding:
    """What the check finds, also where the cases that it looks up were not run."""
    try:
        return check(sources)
    except LookupError:
        return Finding("-", "the cases that it is about are not all there", NOT_RUN)


def _verdict(paper: str, found: Finding) -> Verdict:
    if found.verdict is not None:
        return found.verdict
    assert isinstance(found.here, float)
    return judge(paper, found.here, rounds_down=found.rounds_down)


def write_verdicts(case: VerdictsCase, path: Path) -> None:
    """Write the whole list as CSV."""
    sources = Sources(
        iterations=records.read(Path(case.iterations), ITERATIONS),
        equilibria=records.read(Path(case.equilibria), EQUILIBRIA),
        table4=records.read(Path(case.table4), INERTIA),
        table5=records.read(Path(case.table5), INERTIA),
        table6=records.read(Path(case.table6), ADDED_MASS),
        limits=records.read(Path(case.limits), LIMITS),
        trim=records.read(Path(case.trim), TRIM),
        transients=tuple(records.read(Path(name), TRANSIENT) for name in case.transients),
        pitching=tuple(records.read(Path(name), TRANSIENT) for name in case.pitching),
    )
    rows = [row for name in case.tables for row in table_rows(Path(name))]
    records.save_table(pd.DataFrame(rows + claim_rows(sources))[COLUMNS], path)
