"""The typed schema: the rooms' own dataclasses, one for each task."""

import difflib
import re
from collections.abc import Mapping
from functools import cache
from typing import Any, Literal, NamedTuple

from pydantic import TypeAdapter, ValidationError
from pydantic.dataclasses import dataclass
from pydantic_core import ErrorDetails

from squat.analysis import TableCase, VerdictsCase
from squat.catalogue import CatalogueCase, DifferenceCase
from squat.errors import InputError
from squat.figures import CompareCase, FigureCase
from squat.fluid.inertia import InertiaCase
from squat.fluid.run import AddedMassCase
from squat.fluid.sensitivity import SensitivityCase
from squat.mesh.case import MeshCase
from squat.piston import PistonCase, StudyCase
from squat.quantities import STRICT
from squat.race import RaceCase
from squat.records.identity import HOUSEKEEPING
from squat.reduced.case import ReducedCase
from squat.replay import ReplayCase
from squat.report import ReportCase
from squat.stability.case import LimitsCase, LimitsMapCase, StabilityCase
from squat.stability.run import EquilibriaCase
from squat.sweeps import CollectCase
from squat.transient import TransientCase
from squat.transient.convergence import ConvergenceCase
from squat.transient.stability_map import StabilityMapCase
from squat.trim.case import TrimCase

CASES: dict[str, type] = {
    "piston": PistonCase,
    "iterations": StudyCase,
    "equilibria": EquilibriaCase,
    "stability": StabilityCase,
    "limits": LimitsCase,
    "limits_map": LimitsMapCase,
    "mesh": MeshCase,
    "added_mass": AddedMassCase,
    "inertia": InertiaCase,
    "sensitivity": SensitivityCase,
    "reduced": ReducedCase,
    "transient": TransientCase,
    "race": RaceCase,
    "stability_map": StabilityMapCase,
    "trim": TrimCase,
    "convergence": ConvergenceCase,
    "table": TableCase,
    "verdicts": VerdictsCase,
    "figure": FigureCase,
    "catalogue": CatalogueCase,
    "difference": DifferenceCase,
    "compare": CompareCase,
    "report": ReportCase,
    "replay": ReplayCase,
    "collect": CollectCase,
}


@dataclass(frozen=True, kw_only=True, config=STRICT)
class Settings:
    """Keys that every task has.

    Parameters
    ----------
    task
        Name of the task.
    out
        File to write; None: `<task>.nc` (or `.csv`, `.png`, `.rrd`) in the working directory.
    log_level
        Least severe message shown.
    redo
        Neither skip complete jobs of a multirun nor go on from segments.
    """

    task: str
    out: str | None
    log_level: Literal["debug", "info", "warning", "error"]
    redo: bool


class Valid(NamedTuple):
    """A configuration that passed: settings, the task's case, the plain values."""

    settings: Settings
    case: Any
    config: dict[str, Any]


_SIZE = re.compile(
    r"Tuple should have (?P<size>.+?)(?: after validation)?, not (?P<given>\d+)", re.ASCII
)
_SETTINGS = ("task", *HOUSEKEEPING)


@cache
def _adapter(kind: type) -> TypeAdapter[Any]:
    return TypeAdapter(kind)


def validate(config: Mapping[str, Any]) -> Valid:
    """Checked settings and case from plain containers.

    Raises
    ------
    InputError
        One line: the key, its value, what is wrong, what would be right.
    """
    task = config.get("task")
    if task not in CASES:
        raise InputError(f"task={task}: unknown; give one of {', '.join(sorted(CASES))}")
    common = {key: value for key, value in config.items() if key in _SETTINGS}
    own = {key: value for key, value in config.items() if key not in _SETTINGS}
    try:
        settings = _adapter(Settings).validate_python(common)
        case = _adapter(CASES[task]).validate_python(own)
    except ValidationError as error:
        raise InputError(_one_line(error, dict(config))) from error
    return Valid(settings, case, dict(config))


def _one_line(error: ValidationError, config: Mapping[str, Any]) -> str:
    details = error.errors(include_url=False)
    # A value of the wrong kind says more than the missing keys that it implies.
    details.sort(key=lambda detail: detail["type"] == "missing")
    line = _describe(details[0], config)
    more = len(details) - 1
    return f"{line} (and {more} more)" if more else line


def _describe(detail: ErrorDetails, config: Mapping[str, Any]) -> str:
    path, siblings = _path(detail["loc"], config)
    value, message = detail["input"], detail["msg"]
    if detail["type"] == "value_error":
        reason = str(detail["ctx"]["error"])
        return reason if "=" in reason else f"{path}: {reason}"
    if detail["type"] in ("extra_forbidden", "unexpected_keyword_argument"):
        near = difflib.get_close_matches(path.rsplit(".", 1)[-1], siblings, n=1)
        hint = f"did you mean {near[0]!r}?" if near else "leave it out"
        return f"{path}={_short(value)}: unknown key; {hint}"
    if detail["type"] == "union_tag_not_found":
        tag = str(detail["ctx"]["discriminator"]).strip("'")
        return f"{path}.{tag}: missing; give {path}.{tag}=NAME"
    if detail["type"] == "missing":
        return f"{path}: missing; give {path}=VALUE"
    if found := _SIZE.match(message):
        message = f"must have {found['size']}, not {found['given']}"
    return f"{path}={_short(value)}: {message.replace('Input should', 'must')}"


def _path(loc: tuple[int | str, ...], config: Mapping[str, Any]) -> tuple[str, list[str]]:
    """Dotted key of `loc` without pydantic's union tags, and the keys beside it."""
    keys: list[str] = []
    here: Any = config
    siblings: list[str] = []
    for part in loc:
        if isinstance(here, Mapping):
            if part not in here and part in (here.get("name"), here.get("shape")):
                continue
            siblings = [str(key) for key in here if key != part]
            here = here.get(part)
        elif isinstance(here, list) and isinstance(part, int) and part < len(here):
            here = here[part]
        keys.append(str(part))
    return ".".join(keys) or "configuration", siblings


def _short(value: object) -> str:
    text = " ".join(str(value).split())
    return text if len(text) <= 60 else text[:57] + "..."
