"""A table as CSV for programs and as a page for readers."""

import html
from pathlib import Path

import pandas as pd

from squat import records
from squat.analysis.verdict import DIFFERS, INCONSISTENT, MATCH

_COLOURS: dict[str, str] = {MATCH: "#cdeccd", DIFFERS: "#ffd9b3", INCONSISTENT: "#d9d2f0"}
_STYLE = """
body { font: 15px/1.4 sans-serif; margin: 1em; color: #222; background: #fff; }
table { border-collapse: collapse; }
th, td { padding: 0.25em 0.7em; border-bottom: 1px solid #ddd; text-align: left; }
th { position: sticky; top: 0; background: #fff; }
"""


def write_frame(frame: pd.DataFrame, path: Path) -> None:
    """Write `frame` to `path` (.csv) and beside it as .html, each whole or not at all."""
    with records.atomic(path) as temporary:
        frame.to_csv(temporary, index=False)
    with records.atomic(path.with_suffix(".html")) as temporary:
        temporary.write_text(page(frame, path.stem), encoding="utf-8")


def page(frame: pd.DataFrame, title: str) -> str:
    """`frame` as one HTML page that needs nothing else; verdicts are coloured."""
    head = "".join(f"<th>{html.escape(str(name))}</th>" for name in frame.columns)
    rows = "\n".join(
        "<tr>" + "".join(_cell(value) for value in row) + "</tr>"
        for row in frame.itertuples(index=False)
    )
    count = frame["verdict"].value_counts()
    summary = ", ".join(f"{count[name]} {name}" for name in _COLOURS if name in count)
    return (
        f"<!doctype html>\n<html lang='en'><head><meta charset='utf-8'><title>{title}</title>"
        f"<style>{_STYLE}</style></head><body><p>{len(frame)} rows: {summary}</p>\n"
        f"<table><thead><tr>{head}</tr></thead>\n<tbody>\n{rows}\n</tbody></table>"
        "</body></html>\n"
    )


def _cell(value: object) -> str:
    text = html.escape(str(value))
    colour = _COLOURS.get(str(value))
    style = f" style='background:{colour}'" if colour else ""
    return f"<td{style}>{text}</td>"
