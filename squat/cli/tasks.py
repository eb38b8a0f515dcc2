"""What each task runs and what it writes."""

import logging
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import xarray as xr
from hydra.errors import HydraException
from omegaconf.errors import OmegaConfBaseException

from squat import (
    analysis,
    catalogue,
    figures,
    piston,
    race,
    records,
    reduced,
    report,
    sweeps,
    transient,
)
from squat.cli.messages import condense
from squat.config import compose
from squat.config.schema import Valid
from squat.errors import InputError
from squat.fluid import inertia, sensitivity
from squat.fluid import run as added_mass
from squat.stability import limits, limits_map, portrait
from squat.stability import run as equilibria
from squat.transient import convergence, stability_map
from squat.trim import run as trim

_log = logging.getLogger(__name__)


def _mesh(case: Any) -> xr.Dataset:
    # gmsh takes as long to import as all the rest, and needs graphics libraries.
    from squat.mesh.run import run  # noqa: PLC0415

    return run(case)


def _replay(case: Any, path: Path) -> None:
    # rerun takes a second to import.
    from squat.replay.write import write_replay  # noqa: PLC0415

    write_replay(case, path)


def _collect(case: Any) -> xr.Dataset:
    return sweeps.collect(case, _compose)


def _compose(task: str, *overrides: str) -> dict[str, Any]:
    try:
        return compose(task, *overrides)
    except (HydraException, OmegaConfBaseException) as error:
        raise InputError(condense(error, overrides)) from error


DATASETS: dict[str, Callable[[Any], xr.Dataset]] = {
    "piston": piston.run,
    "iterations": piston.study,
    "equilibria": equilibria.run,
    "stability": portrait.run,
    "stability_map": stability_map.run,
    "trim": trim.run,
    "limits": limits.run,
    "convergence": convergence.run,
    "limits_map": limits_map.run,
    "mesh": _mesh,
    "added_mass": added_mass.run,
    "inertia": inertia.run,
    "sensitivity": sensitivity.run,
    "race": race.run,
    "collect": _collect,
}
TASKS = (*DATASETS, "reduced", "transient")
"""Tasks that make a dataset."""
FILES: dict[str, tuple[str, Callable[[Any, Path], None]]] = {
    "table": (".csv", analysis.write_table),
    "verdicts": (".csv", analysis.write_verdicts),
    "figure": (".png", figures.write_figure),
    "catalogue": (".parquet", catalogue.write_catalogue),
    "difference": (".csv", catalogue.write_difference),
    "compare": (".png", figures.write_compare),
    "report": (".html", report.write_report),
    "replay": (".rrd", _replay),
}


def output(valid: Valid, folder: Path) -> Path:
    """File that the task writes, below `folder` unless `out` is absolute."""
    task = valid.settings.task
    suffix, _ = FILES.get(task, (".nc", None))
    path = folder / (valid.settings.out or f"{task}{suffix}")
    if path.suffix != suffix:
        raise InputError(f"out={path}: must end in {suffix}; task={task} writes no other")
    return path


def is_done(valid: Valid, path: Path) -> bool:
    """Whether `path` holds the whole dataset that this very configuration makes."""
    if valid.settings.task in FILES or not path.is_file():
        return False
    try:
        return records.is_answer(records.read_whole(path), valid.config)
    except InputError:
        return False


def run_task(valid: Valid, path: Path) -> None:
    """Run the task and write `path`."""
    task, started = valid.settings.task, time.perf_counter()
    _, write = FILES.get(task, (".nc", None))
    if write is not None:
        write(valid.case, path)
        _log.info("%s: written", path)
        return
    records.claim(path)
    if task == "transient":
        dataset = _transient(valid, path, started)
    elif task == "reduced":
        dataset, groups = reduced.run(valid.case)
        records.save(dataset, path, valid.config, started, groups)
    else:
        dataset = DATASETS[task](valid.case)
        records.save(dataset, path, valid.config, started)
    _log.info("%s: written%s", path, _headline(dataset))


def _transient(valid: Valid, path: Path, started: float) -> xr.Dataset:
    segments = records.Segments.beside(path, records.strict_identity(valid.config))
    if valid.settings.redo:
        segments.clear()
    dataset, fields = transient.run(valid.case, segments)
    groups = {} if fields is None else {"fields": fields}
    records.save(dataset, path, valid.config, started, groups)
    segments.clear()
    return dataset


def compute(valid: Valid) -> xr.Dataset:
    """Dataset of one of `TASKS`, in memory; snapshots and segments need a file and are left out."""
    if valid.settings.task == "transient":
        return transient.run(valid.case).dataset
    if valid.settings.task == "reduced":
        return reduced.run(valid.case).dataset
    return DATASETS[valid.settings.task](valid.case)


def _headline(dataset: xr.Dataset) -> str:
    status, summary = (dataset.attrs.get(name) for name in ("status", "summary"))
    return (f", status {status}" if status else "") + (f"\n{summary}" if summary else "")
