"""When two runs are the same run: for jobs that need not be done again, and for restarts."""

import hashlib
from collections.abc import Mapping
from functools import cache
from pathlib import Path
from typing import Any

import h5netcdf

import squat
from squat.records.provenance import versions

HOUSEKEEPING = ("out", "log_level", "redo")
"""Keys that change no number of a run."""


def identity(config: Mapping[str, Any]) -> dict[str, Any]:
    """What makes a dataset the answer to `config`: its physics keys, its input files, squat.

    Input files count by the digest of their values, so one that was written again with the same
    values is the same.
    """
    kept = {key: value for key, value in config.items() if key not in HOUSEKEEPING}
    return {"config": kept, "inputs": inputs(config), "squat": squat.__version__}


def strict_identity(config: Mapping[str, Any]) -> dict[str, Any]:
    """`identity` with the code and the libraries: half a run must not go on with other ones."""
    return {**identity(config), "code": _code(), "versions": versions()}


def inputs(config: Mapping[str, Any]) -> dict[str, str]:
    """SHA-256 of the values in each file below the key `inputs`; empty where unreadable."""
    named = config.get("inputs")
    files = named if isinstance(named, Mapping) else {}
    return {key: _content(Path(name)) for key, name in files.items() if name is not None}


def _content(path: Path) -> str:
    try:
        with h5netcdf.File(path, "r") as file:
            return str(file.attrs.get("content_sha256", ""))
    except OSError:
        return ""  # whoever reads the file says what is wrong with it


@cache
def _code() -> str:
    """SHA-256 over squat's own source."""
    root, total = Path(squat.__file__).parent, hashlib.sha256()
    for file in sorted(root.rglob("*.py")):
        total.update(str(file.relative_to(root)).encode())
        total.update(file.read_bytes())
    return total.hexdigest()


def difference(here: Any, there: Any, path: str = "") -> str:
    """First place where two nested values differ, as `key=there in place of here`."""
    if isinstance(here, Mapping) and isinstance(there, Mapping):
        for key in [*here, *(key for key in there if key not in here)]:
            if here.get(key) != there.get(key):
                inner = f"{path}.{key}" if path else str(key)
                return difference(here.get(key), there.get(key), inner)
    return f"{path.removeprefix('config.')}={_short(there)} in place of {_short(here)}"


def _short(value: Any) -> str:
    text = " ".join(str(value).split())
    return text if len(text) <= 40 else text[:37] + "..."
