"""The jobs of a multirun, as its folder shows them: done, failed, missing."""

import json
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import xarray as xr

from squat import records
from squat.errors import InputError
from squat.records.kinds import KINDS
from squat.records.sweep import SWEEP

PLAN = "jobs.json"
"""File in a multirun's folder that names all jobs ever planned there, with their overrides."""
FAILED = "failed.txt"
"""File in a job's folder that says why the job failed."""

Compose = Callable[..., dict[str, Any]]


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
    """

    name: str
    overrides: Sequence[str]
    config: Mapping[str, Any] | None
    dataset: xr.Dataset | None
    failure: str = ""

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


def _plan(folder: Path) -> dict[str, Any]:
    try:
        plan = json.loads((folder / PLAN).read_text(encoding="utf-8"))
    except FileNotFoundError:
        return {"task": "", "jobs": {}}
    except (OSError, ValueError) as error:
        raise InputError(f"{folder / PLAN}: not readable; remove it") from error
    assert isinstance(plan, dict)
    return plan


def find(folder: Path, compose: Compose) -> list[Job]:
    """Jobs of the multirun (or of the plain folder of datasets) in `folder`, in planned order."""
    if not folder.is_dir():
        raise InputError(f"runs={folder}: no such folder; give that of a multirun")
    plan = _plan(folder)
    order = {name: place for place, name in enumerate(plan["jobs"])}
    found: dict[str, Job] = {}
    for path in sorted(folder.rglob("[!.]*.nc")):
        if path.is_file() and (job := _read(path, folder, plan, compose)):
            if job.name in found:
                raise InputError(f"runs={folder}: {job.name} holds several datasets; keep one")
            found[job.name] = job
    for note in sorted(folder.rglob(FAILED)):
        name = str(note.parent.relative_to(folder))
        reason = note.read_text(encoding="utf-8").partition("\n")[0]
        found[name] = _absent(name, plan, compose, reason)
    for name in plan["jobs"]:
        if name not in found:
            found[name] = _absent(name, plan, compose)
    if not any(job.dataset is not None for job in found.values()):
        raise InputError(f"runs={folder}: holds no dataset; give the folder of a multirun")
    return sorted(found.values(), key=lambda job: (order.get(job.name, len(order)), job.name))


def _read(path: Path, folder: Path, plan: Mapping[str, Any], compose: Compose) -> Job | None:
    """The job that wrote `path`; None where it holds a joined sweep."""
    own = path.parent != folder
    name = str(path.parent.relative_to(folder)) if own else path.stem
    try:
        dataset = records.read(path)
    except InputError as error:
        return _absent(name, plan, compose, str(error))
    if kind_of(dataset) == SWEEP.name:
        return None
    return Job(name, plan["jobs"].get(name, ()), records.config_of(dataset), dataset)


def kind_of(dataset: xr.Dataset) -> str:
    """Name of the dataset's kind."""
    name = str(dataset.attrs["schema"]).split("/")[1]
    assert name in KINDS
    return name


def _absent(name: str, plan: Mapping[str, Any], compose: Compose, failure: str = "") -> Job:
    overrides = plan["jobs"].get(name, ())
    config = None
    if overrides:
        try:
            config = compose(plan["task"], *(o for o in overrides if not o.startswith("task=")))
        except InputError as error:  # it may be the very reason why there is no dataset
            failure = failure or str(error)
    return Job(name, overrides, config, None, failure)
