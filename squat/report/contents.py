"""What a report shows, in which order: `conf/contents/`."""

import re
from collections.abc import Iterator
from dataclasses import field
from typing import Annotated

from pydantic import Field
from pydantic.dataclasses import dataclass

from squat.errors import InputError
from squat.quantities import STRICT

_KINDS = ("figure", "table", "claims", "runs", "estimates", "files")


@dataclass(frozen=True, kw_only=True, config=STRICT)
class Block:
    """One figure, table, list of claims, list of runs, table of estimates, or list of files.

    Parameters
    ----------
    figure
        Name of a figure in `figures/`.
    table
        Name of a table in `tables/`.
    claims
        Names of sentences in `published/claims.csv`.
    runs
        Condition on the catalogue of the results.
    columns
        Heads of the columns to show with `runs`, each with its key in the catalogue.
    estimates
        Dataset of kind `convergence` below the results: numbers with their uncertainty.
    files
        Pattern of files below the results, to link to.
    of
        Dataset below the results that a table's numbers are from, to link to.
    title, text
        Heading and caption.
    """

    figure: str | None = None
    table: str | None = None
    claims: tuple[str, ...] | None = None
    runs: str | None = None
    columns: dict[str, str] = field(default_factory=dict)
    estimates: str | None = None
    files: str | None = None
    of: str = ""
    title: str = ""
    text: str = ""

    def __post_init__(self) -> None:
        if sum(getattr(self, kind) is not None for kind in _KINDS) != 1:
            raise InputError(f"contents: a block has one of {', '.join(_KINDS)}; see {self}")

    @property
    def kind(self) -> str:
        """Which of the six it is."""
        return next(kind for kind in _KINDS if getattr(self, kind) is not None)


@dataclass(frozen=True, kw_only=True, config=STRICT)
class Section:
    """A heading with blocks."""

    title: str
    blocks: Annotated[tuple[Block, ...], Field(min_length=1)]
    text: str = ""

    @property
    def anchor(self) -> str:
        """What links to the section end with."""
        return "section-" + re.sub(r"\W+", "-", self.title.lower()).strip("-")


@dataclass(frozen=True, kw_only=True, config=STRICT)
class Part:
    """The paper, or what goes beyond it."""

    title: str
    sections: tuple[Section, ...]
    text: str = ""


@dataclass(frozen=True, kw_only=True, config=STRICT)
class Contents:
    """All parts of a report."""

    parts: Annotated[tuple[Part, ...], Field(min_length=1)]

    @property
    def blocks(self) -> Iterator[Block]:
        """Every block, in order."""
        for part in self.parts:
            for section in part.sections:
                yield from section.blocks


@dataclass(frozen=True, kw_only=True, config=STRICT)
class ReportCase:
    """Which results, and what of them.

    Parameters
    ----------
    results
        Folder that holds `figures/`, `tables/` and datasets.
    members
        Files that share their folders with others, of other configurations, which are left out;
        folders that hold none of them enter as a whole.
    contents
        Parts, sections and blocks.
    """

    results: str
    members: tuple[str, ...]
    contents: Contents
