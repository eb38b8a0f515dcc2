"""The answer of task `trim` in words."""

from collections.abc import Mapping
from typing import Any

from squat.stability.digits import measured
from squat.trim.case import TrimCase

_NAME = 17
_INDENT = (2 + _NAME) * " "


def summary(case: TrimCase, data: Mapping[str, Any]) -> str:
    """Lines for a reader: what each limit is, with its error."""
    start, bow = case.start, data["length"] / 2 * case.start.pitch
    lines = [
        f"released at rest from w(0) = {start.heave:g} m with a pitch of {start.pitch:g} rad, "
        f"{bow:+.2g} m down at the bow",
        _limit(data, "squat_speed", "fold", "beyond it there is no equilibrium near rest"),
        _limit(data, "safe_speed", "safe speed", "up to it the energy keeps the ship, trim free"),
        _limit(data, "dynamic_limit", "lost in the run", f"within {case.periods:g} periods"),
        _limit(data, "heave_only_limit", "heave alone", _alone(case)),
    ]
    return "\n  ".join(lines)


def _limit(data: Mapping[str, Any], variable: str, name: str, what: str) -> str:
    value, error = (float(data[key]) for key in (variable, f"{variable}_error"))
    return f"{name:<{_NAME}}{measured(value, error, 'm/s')}: {what}"


def _alone(case: TrimCase) -> str:
    """What the limit with locked pitch is, and why task=limits gives another."""
    locked = f"pitch locked at {case.start.pitch:g} rad"
    if not case.start.pitch:
        return f"{locked}; task=limits extrapolates the same to a finer mesh"
    return (
        f"{locked}\n{_INDENT}(task=limits locks it at zero and extrapolates: another number; "
        "start.pitch=0 asks about that ship)"
    )
