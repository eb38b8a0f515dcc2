"""Reading and writing: whole files only, errors of one line."""

import gc
import io
import json
import sys
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import pandas as pd
import xarray as xr

from squat.errors import InputError
from squat.records import provenance
from squat.records.intact import intact, sealed
from squat.records.kinds import KINDS
from squat.records.schema import Kind
from squat.records.writing import atomic

_ABSENT = "no such file; give a dataset that squat wrote"
_PACKED = {"zlib": True, "complevel": 4, "shuffle": True, "_FillValue": None}


def stamp(
    dataset: xr.Dataset,
    config: Mapping[str, Any],
    started: float,
    groups: Mapping[str, xr.Dataset] | None = None,
    choices: Mapping[str, str] | None = None,
) -> xr.Dataset:
    """`dataset` with provenance and the seals that `read` asks for; arguments as for `save`."""
    seals = {name: provenance.seal(group) for name, group in (groups or {}).items()}
    stamped = dataset.assign_attrs(
        provenance.attributes(config, started, choices or {}),
        content_sha256=provenance.digest(dataset),
        groups_sha256=json.dumps(seals),
    )
    return stamped.assign_attrs(record_sha256=provenance.seal(stamped))


def save(
    dataset: xr.Dataset,
    path: Path,
    config: Mapping[str, Any],
    started: float,
    groups: Mapping[str, xr.Dataset] | None = None,
    choices: Mapping[str, str] | None = None,
) -> None:
    """Write `dataset` to `path` with provenance, or leave nothing behind.

    Parameters
    ----------
    dataset
        Made by `build`.
    config
        The resolved configuration of the run.
    started
        `time.perf_counter()` [s] when the run began.
    groups
        Snapshots, each written compressed into the group of its name.
    choices
        Names in `conf/` that the configuration was composed of, by their groups.
    """
    stamped = stamp(dataset, config, started, groups, choices)
    no_fill = {name: {"_FillValue": None} for name in stamped.variables}
    whole = io.BytesIO()  # HDF5 on a full disk fails in many lines, or takes the process along
    stamped.to_netcdf(whole, engine="h5netcdf", encoding=no_fill)
    for name, group in (groups or {}).items():
        packed = dict.fromkeys(group.data_vars, _PACKED)
        group.to_netcdf(whole, engine="h5netcdf", group=name, mode="a", encoding=packed)
    with atomic(path) as temporary:
        temporary.write_bytes(sealed(whole.getvalue()))


def save_table(frame: pd.DataFrame, path: Path) -> None:
    """Write `frame` to `path` as CSV, whole or not at all."""
    with atomic(path) as temporary:
        frame.to_csv(temporary, index=False)


def read(path: Path, kind: Kind | None = None) -> xr.Dataset:
    """Dataset in `path`, in memory, once it proved to be whole and of `kind` (None: any).

    Raises
    ------
    InputError
        Naming the file and what is wrong: absent, broken, foreign, newer, altered.
    """
    if not path.is_file():
        why = "is a folder; give a dataset in it" if path.is_dir() else _ABSENT
        raise InputError(f"{path}: {why}")
    if not _intact(path):
        raise _altered(path)
    dataset = _load(path, None, "not a readable NetCDF-4 file")
    found = _kind(dataset, path)
    if kind is not None and found.name != kind.name:
        raise InputError(
            f"{path}: holds {found.name!r} in place of {kind.name!r}; "
            f"give a file written by squat task={kind.name}"
        )
    found.check(dataset, str(path))
    if dataset.attrs.get("record_sha256") != provenance.seal(dataset):
        raise _altered(path)
    return dataset


def read_whole(path: Path) -> xr.Dataset:
    """Dataset in `path` as `read` gives it, once all its groups proved to be whole as well."""
    dataset = read(path)
    for name in _seals(dataset):
        _group(path, name, dataset)
    return dataset


def groups(path: Path) -> tuple[str, ...]:
    """Names of the groups in a file that `read` accepts."""
    return tuple(_seals(read(path)))


def read_group(path: Path, name: str) -> xr.Dataset:
    """Snapshots in the group `name` of `path`; raises InputError as `read` does."""
    dataset = read(path)
    if name not in _seals(dataset):
        joined = "joined" in dataset.attrs
        remedy = (
            "a sweep's jobs keep theirs; open their files" if joined else "run with snapshots=1"
        )
        raise InputError(f"{path}: holds no group {name!r}; {remedy}")
    return _group(path, name, dataset)


def _group(path: Path, name: str, dataset: xr.Dataset) -> xr.Dataset:
    group = _load(path, name, f"group {name!r} is not readable")
    if provenance.seal(group) != _seals(dataset)[name]:
        raise _altered(path)
    return group


def _intact(path: Path) -> bool:
    try:
        return intact(path)
    except OSError as error:
        reason = error.strerror or type(error).__name__
        raise InputError(f"{path}: cannot be read ({reason}); give another file") from error


def _load(path: Path, group: str | None, trouble: str) -> xr.Dataset:
    """A group of `path`, None for its root; InputError that begins with `trouble`."""
    with quiet():
        try:
            with xr.open_dataset(path, engine="h5netcdf", group=group) as file:
                return file.load()
        except Exception as error:  # whatever a damaged file makes its reader say
            reason = type(error).__name__
        gc.collect()  # the half-open file, while it is kept quiet
    raise InputError(f"{path}: {trouble} ({reason}); write it again")


@contextmanager
def quiet() -> Iterator[None]:
    """Without the tracebacks of h5netcdf's files that failed to open, when they are collected."""
    hook = sys.unraisablehook
    sys.unraisablehook = lambda _: None
    try:
        yield
    finally:
        sys.unraisablehook = hook


def _seals(dataset: xr.Dataset) -> dict[str, str]:
    """Seals of the groups by name."""
    seals = json.loads(dataset.attrs["groups_sha256"])
    assert isinstance(seals, dict)
    return seals


def _altered(path: Path) -> InputError:
    return InputError(f"{path}: altered since it was written; write it again")


def _kind(dataset: xr.Dataset, path: Path) -> Kind:
    label = str(dataset.attrs.get("schema", ""))
    parts = label.split("/")
    if len(parts) != 3 or parts[0] != "squat" or not parts[2].isdigit() or parts[1] not in KINDS:
        raise InputError(
            f"{path}: schema {label!r} is not one of squat's; give a file that squat wrote"
        )
    kind = KINDS[parts[1]]
    if int(parts[2]) != kind.version:
        newer = int(parts[2]) > kind.version
        remedy = "update squat" if newer else f"write it again with squat task={kind.name}"
        raise InputError(f"{path}: schema {label!r}, this squat reads {kind.label!r}; {remedy}")
    return kind
