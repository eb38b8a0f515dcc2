"""The typed schema: the rooms' own dataclasses, one for each task."""

import difflib
import re
from collections.abc import Iterator, Mapping
from functools import cache
from pkgutil import resolve_name
from typing import Any, Literal, NamedTuple

from pydantic import TypeAdapter, ValidationError
from pydantic.dataclasses import dataclass
from pydantic_core import ErrorDetails

from squat.errors import InputError
from squat.quantities import STRICT
from squat.records.identity import HOUSEKEEPING

_HOMES = {
    "piston": "squat.piston:PistonCase",
    "iterations": "squat.piston:StudyCase",
    "equilibria": "squat.stability.run:EquilibriaCase",
    "stability": "squat.stability.case:StabilityCase",
    "limits": "squat.stability.case:LimitsCase",
    "limits_map": "squat.stability.case:LimitsMapCase",
    "uneven_bottom": "squat.stability.uneven_bottom:UnevenBottomCase",
    "hull_shapes": "squat.stability.case:HullShapesCase",
    "mesh": "squat.mesh.case:MeshCase",
    "added_mass": "squat.fluid.run:AddedMassCase",
    "inertia": "squat.fluid.inertia:InertiaCase",
    "sensitivity": "squat.fluid.sensitivity:SensitivityCase",
    "reduced": "squat.reduced.case:ReducedCase",
    "transient": "squat.transient:TransientCase",
    "race": "squat.race:RaceCase",
    "stability_map": "squat.transient.stability_map:StabilityMapCase",
    "trim": "squat.trim.case:TrimCase",
    "convergence": "squat.transient.convergence:ConvergenceCase",
    "table": "squat.analysis:TableCase",
    "verdicts": "squat.analysis:VerdictsCase",
    "figure": "squat.figures:FigureCase",
    "catalogue": "squat.catalogue:CatalogueCase",
    "difference": "squat.catalogue:DifferenceCase",
    "compare": "squat.figures:CompareCase",
    "report": "squat.report:ReportCase",
    "replay": "squat.replay:ReplayCase",
    "collect": "squat.sweeps:CollectCase",
}


class Cases(Mapping[str, type]):
    """Dataclass of each task, imported when asked for: a table need not wait for the solvers."""

    def __getitem__(self, task: str) -> type:
        """Raise KeyError where there is no such task."""
        found = resolve_name(_HOMES[task])
        assert isinstance(found, type)
        return found

    def __iter__(self) -> Iterator[str]:
        return iter(_HOMES)

    def __len__(self) -> int:
        return len(_HOMES)


CASES = Cases()


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
    """A configuration that passed: settings, the task's case, the plain values.

    In `config`, null stands only for what the case leaves open too: a number that its classes take
    in place of it (say, a hull's draft from its points) is there, for records and their readers.
    `choices` are the names in `conf/` that it was composed of, by their groups.
    """

    settings: Settings
    case: Any
    config: dict[str, Any]
    choices: Mapping[str, str]


_SIZE = re.compile(
    r"Tuple should have (?P<size>.+?)(?: after validation)?, not (?P<given>\d+)", re.ASCII
)
_SETTINGS = ("task", *HOUSEKEEPING)


@cache
def _adapter(kind: type) -> TypeAdapter[Any]:
    return TypeAdapter(kind)


def validate(config: Mapping[str, Any], choices: Mapping[str, str] | None = None) -> Valid:
    """Checked settings and case from plain containers; `choices` are passed on.

    Raises
    ------
    InputError
        One line: the key, its value, what is wrong, what would be right.
    """
    task = str(config.get("task"))
    if task not in CASES:
        raise InputError(f"task={task}: unknown; give one of {', '.join(sorted(CASES))}")
    common = {key: value for key, value in config.items() if key in _SETTINGS}
    own = {key: value for key, value in config.items() if key not in _SETTINGS}
    try:
        settings = _adapter(Settings).validate_python(common)
        case = _adapter(CASES[task]).validate_python(own)
    except ValidationError as error:
        raise InputError(_one_line(error, dict(config))) from None
    return Valid(settings, case, _settled(config, case), choices or {})


def _settled(config: Mapping[str, Any], made: Any) -> dict[str, Any]:
    """`config` with the numbers of what was `made` from it in place of null."""

    def settled(key: str, value: Any) -> Any:
        found = made.get(key) if isinstance(made, Mapping) else getattr(made, key, None)
        if isinstance(value, Mapping):
            return _settled(value, found)
        return found if value is None and isinstance(found, float) else value

    return {key: settled(key, value) for key, value in config.items()}


def _one_line(error: ValidationError, config: Mapping[str, Any]) -> str:
    details = error.errors(include_url=False)
    # A value of the wrong kind says more than the missing keys that it implies.
    details.sort(key=lambda detail: detail["type"] == "missing")
    if details[0]["type"] == "missing":
        if isinstance(last := details[-1]["loc"][-1], int):
            key, given = _path(details[0]["loc"][:-1], config)[0], details[0]["input"]
            return f"{key}={_short(given)}: has {len(given)} entries; give {last + 1}"
        missing = [_path(detail["loc"], config)[0] for detail in details]
        remedy = " ".join(f"+{key}=VALUE" for key in missing)
        shape = config["hull"].get("shape") if missing[0].startswith("hull.") else None
        file = f", or begin the hull's file with defaults: [{shape}, _self_]" if shape else ""
        return f"{', '.join(missing)}: missing; give {remedy}{file}"
    line = _describe(details[0], config)
    more = len(details) - 1
    return f"{line} (and {more} more)" if more else line


def _describe(detail: ErrorDetails, config: Mapping[str, Any]) -> str:
    path, siblings = _path(detail["loc"], config)
    value, message = detail["input"], detail["msg"]
    if detail["type"] == "value_error":
        reason = str(detail["ctx"]["error"])
        if path.startswith("hulls.") and reason.startswith("hull."):
            reason = path + reason.removeprefix("hull")  # one of many: say which
        named = "=" in reason or reason.startswith(f"{path}.")
        return reason if named else f"{path}: {reason}"
    if detail["type"] in ("extra_forbidden", "unexpected_keyword_argument"):
        near = difflib.get_close_matches(path.rsplit(".", 1)[-1], siblings, n=1)
        hint = f"did you mean {near[0]!r}?" if near else "leave it out"
        return f"{path}={_short(value)}: unknown key; {hint}"
    if detail["type"] == "union_tag_not_found":
        tag = str(detail["ctx"]["discriminator"]).strip("'")
        file = f", or defaults: [NAME, _self_] in the file of {path}=" if path == "hull" else ""
        return f"{path}.{tag}: missing; give {path}.{tag}=NAME{file}"
    if detail["type"] == "tuple_type":
        return f"{path}={_short(value)}: must be a list; give {path}=[{_short(value)}]"
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
        elif isinstance(part, str):
            continue  # a kind that the value, which has no keys, could have been of
        elif isinstance(here, list) and part < len(here):
            here = here[part]
        keys.append(str(part))
    return ".".join(keys) or "configuration", siblings


def _short(value: object) -> str:
    text = " ".join(str(value).split())
    return text if len(text) <= 60 else text[:57] + "..."
