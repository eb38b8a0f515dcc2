"""Locks that end with the process that holds them, however it ends."""

import fcntl
import os
from contextlib import suppress
from pathlib import Path


def lock(path: Path) -> int:
    """Handle of the locked file `path`, made where there is none, for `unlock`.

    Raises
    ------
    BlockingIOError
        Another process holds it.
    OSError
        The folder cannot be written.
    """
    while True:
        handle = os.open(path, os.O_RDWR | os.O_CREAT, 0o666)
        try:
            _hold(handle)
            if os.path.samestat(path.stat(), os.fstat(handle)):
                return handle
        except FileNotFoundError:
            pass  # its holder removed it before this process got it
        except BlockingIOError:
            os.close(handle)
            raise
        os.close(handle)


def _hold(handle: int) -> None:
    try:
        fcntl.flock(handle, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError:
        raise
    except OSError:
        pass  # a file system without locks


def unlock(path: Path, handle: int) -> None:
    """Remove the file `path` that `lock` gave a `handle` of."""
    with suppress(OSError):
        path.unlink()
    os.close(handle)
