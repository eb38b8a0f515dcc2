"""Printed results stand in squat/published alone."""

import io
import re
import tokenize
from functools import cache
from pathlib import Path

import pandas as pd
import yaml

from squat.published import table

ROOT = Path(__file__).parents[2]
PUBLISHED = ROOT / "squat" / "published"


@cache
def printed_results():
    """Printed numbers distinctive enough to be recognised: three digits, or two decimals."""
    inputs = {"table1_piston_parameters.csv"}
    keys = {"mf_over_m", "madd_over_mf", "V_inf", "depth_over_draft", "a_over_T"}
    found = set()
    for path in sorted(PUBLISHED.glob("*.csv")):
        if path.name in inputs:
            continue
        frame = pd.read_csv(path, dtype=str, keep_default_na=False)
        cells = frame.drop(columns=[name for name in keys if name in frame]).to_numpy().ravel()
        found |= {cell.lstrip("-") for cell in cells if _distinctive(cell)}
    return found - printed_inputs()


def printed_inputs():
    """Keys of the tables: mass ratios and geometries are inputs, wherever else they are printed."""
    names = [f"table{n}" for n in range(2, 8) if n != 6]
    return {value for name in names for cell in table(name) for value in cell.keys.values()}


def _distinctive(text):
    digits = re.fullmatch(r"-?(\d+)(?:\.(\d+))?", text)
    if not digits:
        return False
    whole, decimals = digits[1].lstrip("0"), digits[2] or ""
    return len(decimals) >= 2 or len(whole + decimals) >= 3


def literals(path):
    if path.suffix == ".yaml":
        return {_text(value) for value in _leaves(yaml.safe_load(path.read_text()))}
    tokens = tokenize.generate_tokens(io.StringIO(path.read_text()).readline)
    return {token.string for token in tokens if token.type == tokenize.NUMBER}


def _leaves(node):
    if isinstance(node, dict):
        node = list(node.values())
    if isinstance(node, list):
        for part in node:
            yield from _leaves(part)
    elif isinstance(node, int | float):
        yield node


def _text(value):
    return f"{abs(value):g}"


def sources():
    return [*(ROOT / "squat").rglob("*.py"), *(ROOT / "conf").rglob("*.yaml")]


LAYOUT = {"figures", "replay", "report"}
"""Rooms whose numbers place things on a page: two equal digits there are chance."""


CHANCE = {
    "formulas.py": {"0.76"},  # Huuska's K_s = 7.45 S + 0.76
    "count.py": {"0.75"},  # three quarters of a circle at a corner
    "region.py": {"1.01"},  # one percent more
    "run.py": {"1.01"},  # likewise
}


def recognisable(path):
    printed = printed_results() - CHANCE.get(path.name, set())
    if not LAYOUT & set(path.parts):
        return printed
    return {text for text in printed if len(text.replace(".", "").lstrip("0")) > 2}


def test_printed_results_are_known_and_many():
    assert {"1404", "8.46", "2.9"} - printed_results() == {"2.9"}
    assert len(printed_results()) > 10


def test_no_printed_result_is_a_literal_of_code_or_configuration():
    offenders = {
        str(path.relative_to(ROOT)): sorted(found)
        for path in sources()
        if (found := literals(path) & recognisable(path))
    }
    assert offenders == {}
