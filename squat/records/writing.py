"""Writing whole files or none, whatever ends the process."""

import fcntl
import glob
import os
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

from squat.errors import InputError
from squat.records.locks import lock, unlock


class BusyError(InputError):
    """Another run is writing the file."""


@contextmanager
def atomic(path: Path) -> Iterator[Path]:
    """A temporary path beside `path` that replaces it on success and vanishes on failure.

    Raises
    ------
    InputError
        Where `path` cannot be written (missing rights, full disk); an older file stays.
    """
    handle, temporary = -1, None
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        _sweep(path)
        handle, temporary = _claimed(path)
        yield temporary
        _finish(temporary, path)
    except OSError as error:
        raise _unwritable(path, error) from error
    finally:
        if temporary is not None:
            temporary.unlink(missing_ok=True)
            os.close(handle)


@contextmanager
def claim(path: Path) -> Iterator[None]:
    """Make the folder of `path` and keep other runs from writing it meanwhile.

    What could not be written after a long run is refused at once.

    Raises
    ------
    BusyError
        Another run is writing `path`.
    InputError
        Where the folder cannot be made or written to.
    """
    place = path.with_name(f".{path.name}-lock")
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        handle = lock(place)
    except BlockingIOError:
        raise BusyError(
            f"{path}: another run is writing it; wait for it, or give another out="
        ) from None
    except OSError as error:
        raise _unwritable(path, error) from error
    try:
        yield
    finally:
        unlock(place, handle)


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


def _prefix(path: Path) -> str:
    return f".{path.stem}-writing-"


def _claimed(path: Path) -> tuple[int, Path]:
    """A new temporary file beside `path` and its handle, locked for as long as it is open."""
    while True:
        handle, name = tempfile.mkstemp(dir=path.parent, prefix=_prefix(path), suffix=path.suffix)
        with suppress(OSError):  # a file system without locks has nothing swept either
            fcntl.flock(handle, fcntl.LOCK_EX)
        if Path(name).exists():  # else another process took it for a leftover before the lock
            return handle, Path(name)
        os.close(handle)


def _sweep(path: Path) -> None:
    """Remove what killed processes left of earlier attempts at `path`: their locks are gone."""
    pattern = glob.escape(_prefix(path)) + "*" + glob.escape(path.suffix)
    for leftover in path.parent.glob(pattern):
        with suppress(OSError), leftover.open("rb") as file:
            fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
            leftover.unlink(missing_ok=True)
