"""How a computed number is judged against a printed one."""

import math
from decimal import ROUND_DOWN, ROUND_HALF_UP, Decimal
from typing import Literal

Verdict = Literal["match", "differs", "paper inconsistent", "not run"]
MATCH: Verdict = "match"
DIFFERS: Verdict = "differs"
INCONSISTENT: Verdict = "paper inconsistent"
NOT_RUN: Verdict = "not run"
"""Of a sentence about cases that are not all there, where those that are do not refute it."""
FEW_DIGITS = "a match by the few digits printed"
"""In the note of a match that says little."""


def judge(printed: str, here: float, *, rounds_down: bool = False) -> Verdict:
    """`match` when `here`, rounded to the digits of `printed`, equals it.

    Counts are means over steps that the paper `rounds_down`. A dash (an empty
    `printed`) stands for a scheme that does not converge.
    """
    if printed in ("", "inf"):
        return MATCH if math.isinf(here) else DIFFERS
    if not math.isfinite(here):
        return DIFFERS
    paper = Decimal(printed)
    exponent = paper.as_tuple().exponent
    assert isinstance(exponent, int)
    digits = Decimal(1).scaleb(exponent)
    rounded = Decimal(here).quantize(digits, ROUND_DOWN if rounds_down else ROUND_HALF_UP)
    return MATCH if rounded == paper else DIFFERS


def difference(printed: str, here: float) -> float:
    """`here` less the printed value; 0 where both are infinite, NaN where a dash is printed."""
    if not printed:
        return math.nan
    paper = float(printed)
    return 0.0 if paper == here else here - paper


def half_digit(printed: str) -> float:
    """Half a unit of the last digit printed."""
    exponent = Decimal(printed).as_tuple().exponent
    assert isinstance(exponent, int)
    return float(Decimal(1).scaleb(exponent)) / 2
