"""The runs of a recording: datasets as read, their labels, clocks and snapshots."""

import re
from dataclasses import dataclass, replace
from functools import cached_property
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd
import xarray as xr

from squat import records
from squat.catalogue.flat import row_of
from squat.catalogue.telling import differing, named
from squat.errors import InputError
from squat.piston import Piston
from squat.piston.piston import Oscillator
from squat.quantities import Vector
from squat.records.piston_kinds import PISTON
from squat.records.transient_kinds import TRANSIENT
from squat.replay.places import MOVING, file_of
from squat.sweeps.folders import was_cut
from squat.water import Water

_SNAPSHOT = {
    **dict.fromkeys(("x", "z", "velocity_x", "velocity_z", "pressure"), ("time", "node")),
    "face_node": ("face", "corner"),
}
_WELL = ("completed", "converged")
"""What a run's status is that went on to its last step."""


@dataclass(frozen=True, eq=False)
class Clock:
    """Both time axes of some rows: time [s] and phase omega t [rad], each of shape (rows,)."""

    time: Vector
    phase: Vector

    def at(self, rows: Any) -> "Clock":
        """The clock of chosen rows."""
        return Clock(self.time[rows], self.phase[rows])


@dataclass(frozen=True, eq=False)
class Run:
    """One dataset in a recording.

    Parameters
    ----------
    label
        Name among the runs of a recording; empty where it is the only one.
    path, data
        The file and what it holds.
    fields
        Its snapshots; None where it has none.
    number
        Its place among the runs of a recording, which its colour follows from.
    """

    label: str
    path: Path
    data: xr.Dataset
    fields: xr.Dataset | None
    number: int = 0

    @property
    def kind(self) -> str:
        """Kind of the dataset: `transient` or `piston`."""
        return str(self.data.attrs["schema"]).split("/")[1]

    @cached_property
    def config(self) -> dict[str, Any]:
        """Configuration that made the run."""
        return records.config_of(self.data)

    def chosen(self, group: str, own: str) -> str:
        """Name in `conf/` of what was chosen of `group`; `own` where an older file tells none."""
        return records.choices_of(self.data.attrs).get(group, own)

    @cached_property
    def oscillator(self) -> Oscillator:
        """Masses and stiffness of a piston run."""
        return Oscillator.of(Piston(**self.config["piston"]), Water(**self.config["water"]))

    @property
    def omega(self) -> float:
        """Angular frequency [rad/s] of the phase."""
        if self.kind == PISTON.name:
            return self.oscillator.omega
        return float(self.data["omega"])

    def clock(self, time: Vector) -> Clock:
        """Both axes at `time` [s]."""
        return Clock(time, self.omega * time)

    @property
    def steps(self) -> Clock:
        """Clock of the accepted steps."""
        return self.clock(np.asarray(self.data["time"].values, float))

    @property
    def failure(self) -> Clock | None:
        """Clock of the step that did not converge; None where every step did."""
        if not self.data.sizes["failed_iteration"]:
            return None
        return self.clock(self.steps.time[-1:] + float(self.data["time_step"]))

    @property
    def span(self) -> Clock:
        """Clock of start and end, a step that failed included."""
        end = self.failure or self.steps.at([-1])
        return self.clock(np.unique([self.steps.time[0], end.time[0]]))

    @property
    def ended(self) -> str:
        """How and when the run ended: `ends at 9 s`, or `diverged in the step to 0.2 s`."""
        status = str(self.data.attrs["status"])
        how = "ends" if status in _WELL else status
        when = "at" if self.failure is None else "in the step to"
        return f"{how} {when} {self.span.time[-1]:.4g} s"

    def told(self, title: str) -> str:
        """`title` of a picture with the run's label and end; of a single run an early one only."""
        early = self.data.attrs["status"] not in _WELL
        return self.said(f"{title}; {self.ended}" if self.label or early else title)

    def has(self, *names: str) -> bool:
        """Whether the record holds all these variables."""
        return all(name in self.data.variables for name in names)

    def said(self, text: str) -> str:
        """`text` with the run's label where there are several."""
        return f"{self.label}: {text}" if self.label else text


def load(files: tuple[str, ...]) -> tuple[Run, ...]:
    """Runs of one kind, from `files` or from folders that hold one each.

    Raises
    ------
    InputError
        Naming the file that is absent, broken, foreign, or of another kind than the first, or the
        folder that holds no run or several.
    """
    paths = [file_of(Path(name)) for name in files]
    named = zip(paths, labels(paths), strict=True)
    runs = tuple(_load(path, label, number) for number, (path, label) in enumerate(named))
    if len(runs) > 1 and any(was_cut(part) for path in paths for part in path.absolute().parts):
        runs = _by_configuration(runs)
    for run in runs[1:]:
        if run.kind != runs[0].kind:
            raise InputError(
                f"{run.path}: holds {run.kind!r}, {runs[0].path} {runs[0].kind!r}; "
                "give runs of one task"
            )
    return runs


def labels(paths: list[Path]) -> list[str]:
    """Short names that differ: the deepest part of `paths` that does, less what all have in it.

    Of a sweep's folders `hull.draft-8__snapshots-5` and `hull.draft-9__snapshots-5`, `draft 8` and
    `draft 9`. Empty for a single path.

    Raises
    ------
    InputError
        One path twice.
    """
    if len(paths) == 1:
        return [""]
    parts = [path.absolute().with_suffix("").parts[::-1] for path in paths]
    for depth in range(1, max(map(len, parts)) + 1):
        if len({part[:depth] for part in parts}) == len(parts):
            names = [part[min(depth, len(part)) - 1] for part in parts]
            if len(set(names)) == len(names):
                return _less_common(names) if depth > 1 else names
            return ["/".join(part[:depth][::-1]) for part in parts]
    raise InputError(f"run={','.join(map(str, paths))}: one file twice; give each run once")


def _by_configuration(runs: tuple[Run, ...]) -> tuple[Run, ...]:
    """The runs named by the keys that differ between them, as they are where none does."""
    table = pd.DataFrame([row_of(run.data.attrs) for run in runs])
    keys, more = differing(table)
    rows = table[keys].to_dict("records")
    names = [named({str(key): value for key, value in row.items()}, " ") + more for row in rows]
    if len(set(names)) < len(names):
        return runs
    return tuple(replace(run, label=name) for run, name in zip(runs, names, strict=True))


def _less_common(names: list[str]) -> list[str]:
    """Names of jobs without the overrides that all of them share, keys by their last part."""
    overrides = [name.split("__") for name in names]
    common = set(overrides[0]).intersection(*overrides[1:])
    differing = [[word for word in own if word not in common] for own in overrides]
    short = [", ".join(map(_spoken, own)) or "all else" for own in differing]
    if len(set(short)) == len(short):
        return short
    return ["__".join(own) or "all else" for own in differing]


def _spoken(override: str) -> str:
    """`draft 8` of `hull.draft-8`; what is no override stays."""
    key, dash, value = override.partition("-")
    return f"{re.split(r'[.@/]', key)[-1]} {value}" if dash and value else override


def _load(path: Path, label: str, number: int) -> Run:
    data = records.read(path)
    kind = str(data.attrs["schema"]).split("/")[1]
    if kind not in MOVING:
        what = "joins several runs" if kind == "sweep" else f"holds {kind!r}, which does not move"
        raise InputError(f"{path}: {what}; give a file of squat task=transient or task=piston")
    held = kind == TRANSIENT.name and "fields" in records.groups(path)
    return Run(label, path, data, _snapshots(path) if held else None, number)


def _snapshots(path: Path) -> xr.Dataset:
    fields = records.read_group(path, "fields")
    for name, dims in _SNAPSHOT.items():
        if name not in fields or fields[name].dims != dims:
            raise InputError(
                f"{path}: snapshots lack {name!r} over {dims}; run again with snapshots=1"
            )
    return fields
