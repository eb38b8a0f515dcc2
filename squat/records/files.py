"""Reading and writing: whole files only, errors of one line."""

import io
import os
import tempfile
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import h5netcdf
import pandas as pd
import xarray as xr

from squat.errors import InputError
from squat.records import provenance
from squat.records.kinds import KINDS
from squat.records.schema import Kind

_PACKED = {"zlib": True, "complevel": 4, "shuffle": True, "_FillValue": None}


@contextmanager
def atomic(path: Path) -> Iterator[Path]:
    """A temporary path beside `path` that replaces it on success and vanishes on failure.

    Raises
    ------
    InputError
        Where `path` cannot be written (missing rights, full disk); an older file stays.
    """
    temporary: Path | None = None
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        handle, name = tempfile.mkstemp(
            dir=path.parent, prefix=f".{path.stem}-", suffix=path.suffix
        )
        os.close(handle)
        temporary = Path(name)
        yield temporary
        _finish(temporary, path)
    except OSError as error:
        raise _unwritable(path, error) from error
    finally:
        if temporary is not None:
            temporary.unlink(missing_ok=True)


def claim(path: Path) -> None:
    """Make the folder of `path`, and refuse at once what could not be written after a long run.

    Raises
    ------
    InputError
        Where the folder cannot be made or written to.
    """
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise _unwritable(path, error) from error
    if not os.access(path.parent, os.W_OK):
        raise _unwritable(path, PermissionError(0, "the folder is read-only"))


def _unwritable(path: Path, error: OSError) -> InputError:
    reason = error.strerror or str(error).splitlines()[0]
    return InputError(f"{path}: cannot be written ({reason}); give another out=FILE")


def _finish(temporary: Path, path: Path) -> None:
    mask = os.umask(0)
    os.umask(mask)
    temporary.chmod(0o666 & ~mask)
    with temporary.open("rb+") as file:
        os.fsync(file.fileno())
    temporary.replace(path)


def stamp(dataset: xr.Dataset, config: Mapping[str, Any], started: float) -> xr.Dataset:
    """`dataset` with provenance and the digest that `read` asks for; arguments as for `save`."""
    stamped = dataset.assign_attrs(provenance.attributes(config, started))
    return stamped.assign_attrs(content_sha256=provenance.digest(dataset))


def save(
    dataset: xr.Dataset,
    path: Path,
    config: Mapping[str, Any],
    started: float,
    groups: Mapping[str, xr.Dataset] | None = None,
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
    """
    stamped = stamp(dataset, config, started)
    no_fill = {name: {"_FillValue": None} for name in stamped.variables}
    whole = io.BytesIO()  # HDF5 on a full disk fails in many lines, or takes the process along
    stamped.to_netcdf(whole, engine="h5netcdf", encoding=no_fill)
    for name, group in (groups or {}).items():
        packed = dict.fromkeys(group.data_vars, _PACKED)
        group.to_netcdf(whole, engine="h5netcdf", group=name, mode="a", encoding=packed)
    with atomic(path) as temporary:
        temporary.write_bytes(whole.getbuffer())


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
        raise InputError(f"{path}: no such file; give a dataset that squat wrote")
    try:
        with xr.open_dataset(path, engine="h5netcdf") as file:
            dataset = file.load()
    except Exception as error:
        raise InputError(
            f"{path}: not a readable NetCDF-4 file ({type(error).__name__}); write it again"
        ) from error
    found = _kind(dataset, path)
    if kind is not None and found.name != kind.name:
        raise InputError(
            f"{path}: holds {found.name!r} in place of {kind.name!r}; "
            f"give a file written by squat task={kind.name}"
        )
    found.check(dataset, str(path))
    if dataset.attrs.get("content_sha256") != provenance.digest(dataset):
        raise InputError(f"{path}: altered since it was written; write it again")
    return dataset


def groups(path: Path) -> tuple[str, ...]:
    """Names of the groups in a file that `read` accepts."""
    with h5netcdf.File(path, "r") as file:
        return tuple(file.groups)


def read_group(path: Path, name: str) -> xr.Dataset:
    """Snapshots in the group `name` of a dataset that `read` accepts."""
    read(path)
    if name not in groups(path):
        raise InputError(f"{path}: holds no group {name!r}; run with snapshots=1")
    try:
        with xr.open_dataset(path, engine="h5netcdf", group=name) as file:
            return file.load()
    except Exception as error:
        raise InputError(
            f"{path}: group {name!r} is not readable ({type(error).__name__}); write it again"
        ) from error


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
