"""The datasets of a sweep as one, whose dimensions are the swept parameters."""

import itertools
import json
import logging
from collections.abc import Callable, Container, Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np
import xarray as xr
from pydantic.dataclasses import dataclass

from squat import records
from squat.errors import InputError
from squat.quantities import STRICT
from squat.records.identity import HOUSEKEEPING
from squat.records.kinds import KINDS
from squat.records.schema import Kind
from squat.records.sweep import SWEEP, joined_kind
from squat.sweeps.axes import Axis, axes_of, endings
from squat.sweeps.jobs import Compose, Job, find, kind_of
from squat.sweeps.stack import stack

UnitOf = Callable[[str, str], str | None]
Choose = Callable[[str, str], Container[Path]]

_log = logging.getLogger(__name__)


@dataclass(frozen=True, kw_only=True, config=STRICT)
class CollectCase:
    """Which runs to join.

    Parameters
    ----------
    runs
        Folder of a multirun, `multirun/<task>`, or any folder of datasets of one kind.
    where
        A condition on the catalogue's columns; jobs without a dataset satisfy none. Empty: all.
    """

    runs: str
    where: str


def collect(case: CollectCase, compose: Compose, unit: UnitOf, choose: Choose) -> xr.Dataset:
    """Dataset of kind `sweep`.

    Parameters
    ----------
    compose
        Makes a configuration from a task and overrides: for jobs that left no dataset.
    unit
        Unit of a task's dotted key, None where it has none.
    choose
        Files in a folder that satisfy a condition.

    Raises
    ------
    InputError
        Where the folder holds no dataset, or datasets of several kinds or of the same parameters.
    """
    jobs = find(Path(case.runs), compose, choose(case.runs, case.where) if case.where else None)
    kinds = sorted({kind_of(job.dataset) for job in jobs if job.dataset is not None})
    if len(kinds) > 1:
        raise InputError(f"runs={case.runs}: holds {' and '.join(kinds)}; give runs of one kind")
    source = KINDS[kinds[0]]
    placed = [job for job in jobs if job.config is not None]
    axes = _axes(placed, source)
    cells = _cells(placed, axes, case.runs)
    shape = tuple(len(axis.values) for axis in axes)
    datasets = {place: job.dataset for place, job in cells.items() if job.dataset is not None}
    variables, data = stack(source, datasets, [axis.name for axis in axes], shape)
    keys = {axis.name: axis.key for axis in axes}
    variables = {name: one for name, one in variables.items() if name not in keys}
    data |= {axis.name: np.array(axis.values) for axis in axes}
    data |= _labels(cells, shape)
    own = {name: [list(variable.dims), variable.units] for name, variable in variables.items()}
    dataset = records.build(
        joined_kind(variables, keys),
        data,
        {
            "joined": json.dumps({"schema": source.label, "variables": own}),
            "axes": json.dumps(keys),
            "common_config": json.dumps(_common([job.config for job in placed])),
            **_lost(jobs, cells, axes),
        },
    )
    for name, key in keys.items():
        del dataset[name].attrs["units"]
        if found := unit(source.name, key):
            dataset[name].attrs["units"] = found
    return dataset


def _axes(jobs: Sequence[Job], source: Kind) -> list[Axis]:
    """What was swept, under names that no other variable of the sweep has."""
    dims = {dim for variable in source.variables.values() for dim in variable.dims}
    axes = axes_of(jobs, {*source.variables, *dims, *SWEEP.variables})
    return [axis._replace(name=_holder(axis, source, jobs) or axis.name) for axis in axes]


def _holder(axis: Axis, source: Kind, jobs: Sequence[Job]) -> str:
    """The scalar variable that holds the axis's value in every dataset; empty: there is none."""
    scalars = (
        name
        for name in endings(axis.key)
        if name in source.variables and not source.variables[name].dims
    )
    return next((name for name in scalars if all(_holds(job, name, axis) for job in jobs)), "")


def _holds(job: Job, name: str, axis: Axis) -> bool:
    return job.dataset is None or (
        name in job.dataset and job.dataset[name].item() == axis.of[job.name]
    )


def _cells(jobs: Sequence[Job], axes: Sequence[Axis], runs: str) -> dict[tuple[int, ...], Job]:
    cells: dict[tuple[int, ...], Job] = {}
    for job in jobs:
        place = tuple(axis.values.index(axis.of[job.name]) for axis in axes)
        if place in cells:
            raise InputError(
                f"runs={runs}: {cells[place].name} and {job.name} have the same parameters; "
                "keep one"
            )
        cells[place] = job
    return cells


def _labels(cells: Mapping[tuple[int, ...], Job], shape: tuple[int, ...]) -> dict[str, Any]:
    status, name, failure = (np.full(shape, word, object) for word in ("missing", "", ""))
    for place, job in cells.items():
        status[place], name[place], failure[place] = job.status, job.name, job.failure
    return {
        "job_status": status.astype(str),
        "job_name": name.astype(str),
        "job_failure": failure.astype(str),
    }


def _common(configs: Sequence[Any]) -> Any:
    """What all configurations share."""
    first = configs[0]
    if all(isinstance(config, Mapping) for config in configs):
        shared = [
            key
            for key in first
            if key not in HOUSEKEEPING and all(key in config for config in configs)
        ]
        inner = {key: _common([config[key] for config in configs]) for key in shared}
        return {key: value for key, value in inner.items() if value is not None}
    return first if all(config == first for config in configs) else None


def _lost(
    jobs: Sequence[Job], cells: Mapping[tuple[int, ...], Job], axes: Sequence[Axis]
) -> dict[str, str]:
    """Names of the failed and the missing jobs, said aloud too."""
    failed = {job.name: job.failure for job in jobs if job.status == "failed"}
    missing = [job.name for job in jobs if job.status == "missing"]
    for place in itertools.product(*(range(len(axis.values)) for axis in axes)):
        if place not in cells:
            words = zip(axes, place, strict=True)
            missing.append(" ".join(f"{axis.key}={_plain(axis.values[n])}" for axis, n in words))
    for name, reason in failed.items():
        _log.warning("%s: failed: %s", name, reason)
    for name in missing:
        _log.warning("%s: missing", name)
    return {"failed": json.dumps(failed), "missing": json.dumps(missing)}


def _plain(value: float | str) -> str:
    return f"{value:g}" if isinstance(value, float) else value
