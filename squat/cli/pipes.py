"""The end of a command whose output nobody reads on: `squat --help | head -3`."""

import os
import sys
from collections.abc import Iterator
from contextlib import contextmanager

_CLOSED = 141
"""Exit code of what a closed pipe ends, 128 + SIGPIPE."""


@contextmanager
def quiet_end() -> Iterator[None]:
    """End with that code and without a word where standard output, or the log, is closed."""
    try:
        try:
            yield
        finally:
            if sys.stdout is not None:  # closed from the start: nothing is written to it
                sys.stdout.flush()
    except BrokenPipeError:
        nowhere = os.open(os.devnull, os.O_WRONLY)
        os.dup2(nowhere, sys.stdout.fileno())  # what is left unwritten fails no second time
        sys.exit(_CLOSED)
