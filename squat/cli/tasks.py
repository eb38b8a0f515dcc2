"""What each task runs and what it writes."""

import logging
import time
from collections.abc import Iterator, Mapping
from contextlib import suppress
from pathlib import Path
from pkgutil import resolve_name
from typing import Any

import xarray as xr

from squat import records
from squat.cli.endings import ending
from squat.config import compose, validate
from squat.config.schema import Valid
from squat.config.units import unit
from squat.errors import InputError

_log = logging.getLogger(__name__)


def collect(case: Any) -> xr.Dataset:
    """Dataset of kind `sweep`; jobs without one are known by the configuration composed here."""
    dataset: xr.Dataset = resolve_name("squat.sweeps:collect")(case, _compose, unit, _chosen)
    return dataset


def _compose(task: str, *overrides: str) -> tuple[dict[str, Any], str]:
    config = compose(task, *overrides)
    try:
        return validate(config).config, ""
    except InputError as error:
        return config, str(error)


def _chosen(runs: str, where: str) -> set[Path]:
    catalogue = resolve_name("squat.catalogue")
    frame = catalogue.select(catalogue.find(catalogue.places(runs)), where)
    if frame.empty:
        raise InputError(f"where={where}: no run in {runs} satisfies it; task=catalogue lists them")
    return set(map(Path, frame["file"]))


def compare(case: Any, path: Path) -> None:
    """Picture of chosen runs; units of configuration keys are known here."""
    resolve_name("squat.figures:write_compare")(case, path, unit)


DATASETS = {
    "piston": "squat.piston:run",
    "iterations": "squat.piston:study",
    "equilibria": "squat.stability.run:run",
    "stability": "squat.stability.portrait:run",
    "stability_map": "squat.transient.stability_map:run",
    "trim": "squat.trim.run:run",
    "limits": "squat.stability.limits:run",
    "convergence": "squat.transient.convergence:run",
    "limits_map": "squat.stability.limits_map:run",
    "uneven_bottom": "squat.stability.uneven_bottom:run",
    "hull_shapes": "squat.stability.hull_shapes:run",
    "mesh": "squat.mesh.run:run",
    "added_mass": "squat.fluid.run:run",
    "inertia": "squat.fluid.inertia:run",
    "sensitivity": "squat.fluid.sensitivity:run",
    "race": "squat.race:run",
    "collect": "squat.cli.tasks:collect",
}
"""What makes the dataset of a task; like all below imported when its task is asked for."""
GROUPED = {"transient": "squat.transient:run", "reduced": "squat.reduced:run"}
"""The same with groups beside the dataset."""
TASKS = (*DATASETS, *GROUPED)
"""Tasks that make a dataset."""
FILES = {
    "table": (".csv", "squat.analysis:write_table"),
    "verdicts": (".csv", "squat.analysis:write_verdicts"),
    "figure": (".png", "squat.figures:write_figure"),
    "catalogue": (".parquet", "squat.catalogue:write_catalogue"),
    "difference": (".csv", "squat.catalogue:write_difference"),
    "compare": (".png", "squat.cli.tasks:compare"),
    "report": (".html", "squat.report:write_report"),
    "replay": (".rrd", "squat.replay.write:write_replay"),
}
"""Suffix of what any other task writes, and what writes it."""


def output(valid: Valid, folder: Path) -> Path:
    """File that the task writes, below `folder` unless `out` is absolute."""
    task = valid.settings.task
    suffix, _ = FILES.get(task, (".nc", ""))
    path = folder / (valid.settings.out or f"{task}{suffix}")
    if path.suffix != suffix:
        raise InputError(f"out={path}: must end in {suffix}; task={task} writes no other")
    return path


def earlier_end(valid: Valid, path: Path) -> str:
    """How the run of this very configuration ended that `path` holds whole; empty: it does not."""
    if valid.settings.task in FILES or not path.is_file():
        return ""
    try:
        dataset = records.read_whole(path)
    except InputError:
        return ""
    done = records.is_answer(dataset, valid.config)
    return str(dataset.attrs.get("status", "completed")) if done else ""


def run_task(valid: Valid, path: Path) -> None:
    """Run the task and write `path`."""
    task, started = valid.settings.task, time.perf_counter()
    if task in FILES:
        resolve_name(FILES[task][1])(valid.case, path)
        _log.info("%s: written", path)
        return
    with records.claim(path):
        for remark in filter(None, remarks(valid.case)):
            _log.info("%s", remark)
        dataset = _written(valid, path, started)
    _log.info("%s: written%s", path, ending(dataset, valid.case))


def remarks(case: Any) -> Iterator[str]:
    """What a user should be told of a case's hull and channel before it runs; empty: nothing."""
    hull = getattr(case, "hull", None)
    if hull is not None:
        yield hull.remark()
        if getattr(case, "free_surface", None) == "rigid_lid":
            yield case.channel.remark(hull)


def _written(valid: Valid, path: Path, started: float) -> xr.Dataset:
    task = valid.settings.task
    if task == "transient":
        return _transient(valid, path, started)
    dataset: xr.Dataset
    groups: Mapping[str, xr.Dataset] = {}
    if task == "reduced":
        dataset, groups = resolve_name(GROUPED["reduced"])(valid.case)
    else:
        dataset = resolve_name(DATASETS[task])(valid.case)
    records.save(dataset, path, valid.config, started, groups, valid.choices)
    return dataset


def _transient(valid: Valid, path: Path, started: float) -> xr.Dataset:
    segments = records.Segments.beside(path, records.strict_identity(valid.config))
    if valid.settings.redo:
        segments.clear()
    dataset: xr.Dataset
    dataset, fields = resolve_name(GROUPED["transient"])(valid.case, segments)
    groups = {} if fields is None else {"fields": fields}
    records.save(dataset, path, valid.config, started, groups, valid.choices)
    segments.clear()
    return dataset


def drop_segments(path: Path) -> None:
    """Remove the segments of a whole `path` that a kill left, unless a run is at work on it."""
    segments = records.Segments.beside(path, {})
    if segments.folder.is_dir():
        with suppress(InputError), records.claim(path):
            segments.clear()


def compute(valid: Valid) -> xr.Dataset:
    """Dataset of one of `TASKS`, in memory; snapshots and segments need a file and are left out."""
    task = valid.settings.task
    found: Any = resolve_name({**DATASETS, **GROUPED}[task])(valid.case)
    dataset: xr.Dataset = found.dataset if task in GROUPED else found
    return dataset
