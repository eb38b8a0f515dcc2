"""Where a dataset comes from: configuration, versions, revision, command, wall time."""

import hashlib
import json
import shlex
import subprocess
import sys
import time
from collections.abc import Mapping
from datetime import UTC, datetime
from functools import cache
from importlib.metadata import version
from pathlib import Path
from typing import Any

import h5netcdf
import numpy as np
import xarray as xr
from pydantic import TypeAdapter

import squat
from squat.records.intact import intact

CONVENTIONS = "CF-1.11"
PAPER = (
    "E. Lefrançois, B. Yang, S. Kaidi, N. Mohamad, Overcoming the added mass effect in FSI "
    "calculations relating to dynamic squat, Ocean Engineering 267 (2023) 113280, "
    "doi:10.1016/j.oceaneng.2022.113280"
)
_LIBRARIES = ("numpy", "scipy", "xarray", "h5netcdf", "h5py", "hydra-core", "gmsh")


@cache
def revision() -> str:
    """Git revision of the source tree that runs, with `-dirty`; `unknown` outside of one."""
    root = Path(squat.__file__).parents[1]
    if not (root / ".git").exists():
        return "unknown"
    command = ["git", "-C", str(root), "describe", "--always", "--dirty", "--abbrev=40"]
    try:
        done = subprocess.run(command, capture_output=True, text=True, check=False)
    except OSError:
        return "unknown"
    return done.stdout.strip() or "unknown"


def versions() -> dict[str, str]:
    """Version of Python, squat and the libraries that numbers depend on."""
    found = {name: version(name) for name in ("squat", *_LIBRARIES)}
    return {"python": sys.version.split()[0], **found}


def attributes(
    config: Mapping[str, Any], started: float, choices: Mapping[str, str]
) -> dict[str, str | float]:
    """CF and provenance attributes; `started` is the run's `time.perf_counter()` [s]."""
    now = datetime.now(UTC).isoformat(timespec="seconds")
    return {
        "Conventions": CONVENTIONS,
        "history": f"{now} {shlex.join(['squat', *sys.argv[1:]])}",
        "source": f"squat {squat.__version__}",
        "references": PAPER,
        "config": json.dumps(config),
        "choices": json.dumps(choices),
        "inputs": json.dumps(inputs(config)),
        "versions": json.dumps(versions()),
        "git_revision": revision(),
        "wall_time": round(time.perf_counter() - started, 6),
    }


def inputs(config: Mapping[str, Any]) -> dict[str, str]:
    """SHA-256 of the values in each file below the key `inputs`; empty where unreadable."""
    named = config.get("inputs")
    files = named if isinstance(named, Mapping) else {}
    return {key: _content(Path(name)) for key, name in files.items() if name is not None}


def _content(path: Path) -> str:
    try:
        if not intact(path):
            return ""
        with h5netcdf.File(path, "r") as file:
            return str(file.attrs.get("content_sha256", ""))
    except OSError:
        return ""  # whoever reads the file says what is wrong with it


def config_of(dataset: xr.Dataset) -> dict[str, Any]:
    """Configuration that `dataset` was made with, as plain containers."""
    found = json.loads(dataset.attrs["config"])
    assert isinstance(found, dict)
    return found


def choices_of(attributes: Mapping[str, Any]) -> dict[str, str]:
    """Names in `conf/` that a file's configuration was composed of; none in older files."""
    found = json.loads(attributes.get("choices", "{}"))
    assert isinstance(found, dict)
    return found


def plain(value: Any) -> Any:
    """Dataclasses and tuples as a configuration's JSON has them."""
    return json.loads(json.dumps(TypeAdapter(type(value)).dump_python(value, mode="json")))


def seal(dataset: xr.Dataset) -> str:
    """SHA-256 over all that `dataset` holds: values, and every attribute but the seal itself."""
    kept = {name: value for name, value in dataset.attrs.items() if name != "record_sha256"}
    attributes = {str(name): variable.attrs for name, variable in dataset.variables.items()}
    text = json.dumps([kept, attributes], sort_keys=True, default=lambda v: np.asarray(v).tolist())
    return hashlib.sha256((digest(dataset) + text).encode()).hexdigest()


def digest(dataset: xr.Dataset) -> str:
    """SHA-256 over names, dimensions and values: equal for equal physics, whoever ran it."""
    total = hashlib.sha256()
    for name in sorted(map(str, dataset.variables)):
        variable = dataset.variables[name]
        total.update(repr((name, variable.dims, variable.shape)).encode())
        values = variable.values
        if values.dtype.kind in "OUST":
            total.update(json.dumps(values.astype(str).tolist()).encode())
        else:
            total.update(np.ascontiguousarray(values, values.dtype.newbyteorder("<")).tobytes())
    return total.hexdigest()
