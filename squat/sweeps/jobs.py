"""The jobs of a multirun, as its folder shows them: done, failed, missing."""

import json
from collections.abc import Callable, Container, Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any, NamedTuple

import xarray as xr

from squat import records
from squat.errors import InputError
from squat.records.kinds import KINDS
from squat.records.sweep import SWEEP

PLAN = "jobs.json"
"""File in a multirun's folder that names all jobs ever planned there, with their overrides."""
FAILED = "failed.txt"
"""File in a job's folder that says why the job failed."""

Compose = Callable[..., tuple[dict[str, Any], str]]
"""Configuration of a task and overrides, and why it is refused; empty: it is not."""


@dataclass(frozen=True, eq=False)
class Job:
    """One job of a sweep.

    Parameters
    ----------
    name
        Its folder's name, or its file's in a folder of datasets.
    overrides
        What the command line gave it; empty where no plan tells.
    config
        Its configuration; None where that cannot be told.
    dataset
        What it wrote, None where it failed or never ended.
    failure
        Why there is no dataset; empty where there is one.
    refused
        Whether its configuration holds what no run may have, so that nothing ran.
    """

    name: str
    overrides: Sequence[str]
    config: Mapping[str, Any] | None
    dataset: xr.Dataset | None
    failure: str = ""
    refused: bool = False

    @property
    def status(self) -> str:
        """How the dataset says that its run ended; `failed` or `missing` without one."""
        if self.dataset is not None:
            return str(self.dataset.attrs.get("status", "completed"))
        return "failed" if self.failure else "missing"


def write_plan(folder: Path, task: str, jobs: Mapping[str, Sequence[str]]) -> None:
    """Add `jobs`, overrides by name, to those planned in `folder`."""
    known = _plan(folder)["jobs"]
    plan = {"task": task, "jobs": {**known, **{name: list(job) for name, job in jobs.items()}}}
    with records.atomic(folder / PLAN) as temporary:
        temporary.write_text(json.dumps(plan, indent=1) + "\n", encoding="utf-8")


class Planned(NamedTuple):
    """A job as a sweep planned it."""

    task: str
    overrides: Sequence[str]


def _planned(folder: Path) -> dict[str, Planned]:
    """Jobs that any sweep in `folder` planned, by their folders' names."""
    found = {}
    for path in sorted(folder.rglob(PLAN)):
        plan, place = _plan(path.parent), path.parent.relative_to(folder)
        for name, overrides in plan["jobs"].items():
            found[str(place / name)] = Planned(plan["task"], overrides)
    return found


def _plan(folder: Path) -> dict[str, Any]:
    try:
        plan = json.loads((folder / PLAN).read_text(encoding="utf-8"))
    except FileNotFoundError:
        return {"task": "", "jobs": {}}
    except (OSError, ValueError) as error:
        raise InputError(f"{folder / PLAN}: not readable; remove it") from error
    assert isinstance(plan, dict)
    return plan


def find(folder: Path, compose: Compose, chosen: Container[Path] | None = None) -> list[Job]:
    """Jobs of the multirun (or of the plain folder of datasets) in `folder`, in planned order.

    Of `chosen` files only those that wrote them; None: all, with those that left no dataset.
    """
    if not folder.is_dir():
        raise InputError(f"runs={folder}: no such folder; give that of a multirun")
    plan = _planned(folder)
    order = {name: place for place, name in enumerate(plan)}
    found: dict[str, Job] = {}
    for path in sorted(folder.rglob("[!.]*.nc")):
        if not path.is_file() or (chosen is not None and path not in chosen):
            continue
        if job := _read(path, folder, plan, compose):
            if job.name in found:
                raise InputError(f"runs={folder}: {job.name} holds several datasets; keep one")
            found[job.name] = job
    whole = [job.config for job in found.values() if job.dataset is not None]
    if chosen is None:
        tasks = {config["task"] for config in whole if config}
        same = {name: job for name, job in plan.items() if not tasks or job.task in tasks}
        found |= _without(folder, same, compose, found)
    if not whole:
        raise InputError(f"runs={folder}: holds no dataset; {_remedy(found.values())}")
    jobs = [
        replace(job, config=_filled(job.config, whole[0])) if job.refused else job
        for job in found.values()
    ]
    return sorted(jobs, key=lambda job: (order.get(job.name, len(order)), job.name))


def _remedy(jobs: Iterable[Job]) -> str:
    lost = [job.failure for job in jobs if job.status == "failed"]
    if not lost:
        return "give the folder of a multirun"
    return f"all jobs failed ({FAILED} in their folders: {lost[0]}); mend them and sweep again"


def _without(
    folder: Path, plan: Mapping[str, Planned], compose: Compose, found: Container[str]
) -> dict[str, Job]:
    """Jobs that failed, and planned ones that are not among those `found`."""
    absent = {}
    for note in sorted(folder.rglob(FAILED)):
        name = str(note.parent.relative_to(folder))
        reason = note.read_text(encoding="utf-8").partition("\n")[0]
        absent[name] = _absent(name, plan, compose, reason)
    for name in plan:
        if name not in found and name not in absent:
            absent[name] = _absent(name, plan, compose)
    return absent


def _read(path: Path, folder: Path, plan: Mapping[str, Planned], compose: Compose) -> Job | None:
    """The job that wrote `path`; None where it holds a joined sweep."""
    own = path.parent != folder
    name = str(path.parent.relative_to(folder)) if own else path.stem
    try:
        dataset = records.read(path)
    except InputError as error:
        return _absent(name, plan, compose, str(error))
    if kind_of(dataset) == SWEEP.name:
        return None
    return Job(name, _of(name, plan).overrides, records.config_of(dataset), dataset)


def kind_of(dataset: xr.Dataset) -> str:
    """Name of the dataset's kind."""
    name = str(dataset.attrs["schema"]).split("/")[1]
    assert name in KINDS
    return name


def _of(name: str, plan: Mapping[str, Planned]) -> Planned:
    return plan.get(name, Planned("", ()))


def _absent(name: str, plan: Mapping[str, Planned], compose: Compose, failure: str = "") -> Job:
    task, overrides = _of(name, plan)
    config, refusal = None, ""
    if overrides:
        own = (word for word in overrides if not word.startswith("task="))
        try:
            config, refusal = compose(task, *own)
        except InputError as error:
            refusal = str(error)
    return Job(name, overrides, config, None, failure or refusal, refused=bool(refusal))


def _filled(config: Any, like: Any) -> Any:
    """`config` with what a whole job has in place of null: the number that follows there."""
    if not isinstance(config, Mapping) or not isinstance(like, Mapping):
        return like if config is None and isinstance(like, float) else config
    return {key: _filled(value, like.get(key)) for key, value in config.items()}
