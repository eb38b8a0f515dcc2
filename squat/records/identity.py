"""When two runs are the same run: for jobs that need not be done again, and for restarts."""

import hashlib
import json
from collections.abc import Iterator, Mapping
from functools import cache
from pathlib import Path
from typing import Any

import xarray as xr

import squat
from squat.records.provenance import config_of, inputs, versions

HOUSEKEEPING = ("out", "log_level", "redo")
"""Keys that change no number of a run."""
_NAMED = 4  # differences that a line has room for


def identity(config: Mapping[str, Any]) -> dict[str, Any]:
    """What makes a dataset the answer to `config`: its physics keys, its input files, squat.

    Input files count by the digest of their values, so one that was written again with the same
    values is the same.
    """
    kept = {key: value for key, value in config.items() if key not in HOUSEKEEPING}
    return {"config": kept, "inputs": inputs(config), "squat": squat.__version__}


def is_answer(dataset: xr.Dataset, config: Mapping[str, Any]) -> bool:
    """Whether `dataset`, as `read`, has the identity of `config`: a run of it would be in vain."""
    made = {
        "config": {key: v for key, v in config_of(dataset).items() if key not in HOUSEKEEPING},
        "inputs": json.loads(dataset.attrs.get("inputs", "{}")),
        "squat": json.loads(dataset.attrs["versions"]).get("squat"),
    }
    return bool(made == json.loads(json.dumps(identity(config))))


def strict_identity(config: Mapping[str, Any]) -> dict[str, Any]:
    """`identity` with the code and the libraries: half a run must not go on with other ones."""
    return {**identity(config), "code": _code(), "versions": versions()}


@cache
def _code() -> str:
    """SHA-256 over squat's own source."""
    root, total = Path(squat.__file__).parent, hashlib.sha256()
    for file in sorted(root.rglob("*.py")):
        total.update(str(file.relative_to(root)).encode())
        total.update(file.read_bytes())
    return total.hexdigest()


def difference(here: Any, there: Any) -> str:
    """Where two nested values differ, as `key=there in place of here`; a few places by name."""
    found = list(_differing(here, there))
    more = f" and {len(found) - _NAMED} more" if len(found) > _NAMED else ""
    return ", ".join(found[:_NAMED]) + more


def _differing(here: Any, there: Any, path: str = "") -> Iterator[str]:
    if isinstance(here, Mapping) and isinstance(there, Mapping):
        for key in [*here, *(key for key in there if key not in here)]:
            inner = f"{path}.{key}" if path else str(key)
            yield from _differing(here.get(key), there.get(key), inner)
    elif here != there:
        yield f"{path.removeprefix('config.')}={_short(there)} in place of {_short(here)}"


def _short(value: Any) -> str:
    text = " ".join(str(value).split())
    return text if len(text) <= 40 else text[:37] + "..."
