"""Put the page together."""

import re
from importlib.resources import files as resources
from pathlib import Path
from typing import Any, NamedTuple

import jinja2
import pandas as pd

import squat
from squat import catalogue, records
from squat.errors import InputError
from squat.records.provenance import PAPER
from squat.report.contents import Block, Part, ReportCase, Section
from squat.report.estimates import estimates
from squat.report.members import Members
from squat.report.pictures import picture
from squat.report.provenance import provenance
from squat.report.tables import grid, read, short, symbol
from squat.report.verdicts import VERDICTS, Count, claim_rows, count, of_block


class Shown(NamedTuple):
    """A block with what it shows."""

    block: Block
    view: Any


class Chapter(NamedTuple):
    """A section with its blocks and the tally of its verdicts."""

    section: Section
    blocks: list[Shown]
    tally: Count


def write_report(case: ReportCase, path: Path) -> None:
    """Write the report of `case.results` to `path`, one file that needs no other.

    Links lead to files in `case.results`; they work where the report lies in that folder.

    Raises
    ------
    InputError
        A figure, table or verdict that the contents name is not there.
    """
    results = Path(case.results)
    if not results.is_dir():
        raise InputError(f"results={results}: no such folder; run snakemake all first")
    members = Members(results, case.members)
    verdicts = read(results / "tables" / "verdicts.csv")
    parts = [
        (part, [_chapter(section, members, verdicts) for section in part.sections])
        for part in case.contents.parts
    ]
    text = _page(parts, verdicts, members)
    with records.atomic(path) as temporary:
        temporary.write_text(text, encoding="utf-8")


def _chapter(section: Section, members: Members, verdicts: pd.DataFrame) -> Chapter:
    blocks = [Shown(block, _view(block, members, verdicts)) for block in section.blocks]
    return Chapter(section, blocks, count([v for shown in blocks for v in of_block(*shown)]))


def _view(block: Block, members: Members, verdicts: pd.DataFrame) -> Any:
    """What the template needs to show `block`."""
    results = members.results
    if block.figure is not None:
        return picture(results, block.figure)
    if block.table is not None:
        if not (results / block.of).exists():
            raise InputError(f"{results / block.of}: no such file; run snakemake all first")
        return grid(block.table, read(results / "tables" / f"{block.table}.csv"))
    if block.claims is not None:
        return claim_rows(verdicts, block.claims)
    if block.runs is not None:
        return _runs(block, members)
    if block.estimates is not None:
        return estimates(results / block.estimates)
    assert block.files is not None
    return members.like(block.files)


def _runs(block: Block, members: Members) -> tuple[list[str], list[list[str]]]:
    """Heads and rows of the catalogue that a block asks for."""
    keys = list(block.columns.values())
    found = catalogue.select(catalogue.find(members.datasets), block.runs or "", keys[:2])
    shown = catalogue.columns(found, keys)
    rows = [["–" if pd.isna(v) else short(str(v)) for v in row] for row in shown.to_numpy()]
    return list(block.columns), rows


def _page(parts: list[tuple[Part, list[Chapter]]], verdicts: pd.DataFrame, members: Members) -> str:
    package = resources("squat.report")
    environment = jinja2.Environment(
        autoescape=True,
        undefined=jinja2.StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
    )
    environment.filters |= {"short": short, "symbol": symbol}
    environment.filters["sentence"] = lambda text: text if text.endswith(("?", ".")) else f"{text}."
    environment.filters["slug"] = lambda text: re.sub(r"\W+", "-", str(text))
    paper, _, doi = PAPER.partition("doi:")
    template = environment.from_string(package.joinpath("page.html.j2").read_text("utf-8"))
    return template.render(
        style=package.joinpath("style.css").read_text("utf-8"),
        parts=parts,
        rows={verdict: verdicts[verdicts["verdict"] == verdict] for verdict in VERDICTS},
        total=count(list(verdicts["verdict"])),
        provenance=provenance(members),
        strangers=members.strangers,
        paper=paper,
        doi=doi,
        version=squat.__version__,
    )
