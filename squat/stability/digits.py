"""Numbers in words, with the digits that their errors leave."""

import math

_MOST_DIGITS = 7


def measured(value: float, error: float, unit: str = "") -> str:
    """`value` with two digits of its `error`, or what digits a number without one deserves."""
    if not math.isfinite(value):
        return "none"
    if not math.isfinite(error) or error <= 0:
        return f"{value:.6g} {unit}".strip()
    digits = min(max(0, 1 - math.floor(math.log10(error))), _MOST_DIGITS)
    return f"{value:.{digits}f} +- {error:.1e} {unit}".strip()
