"""Progress of long work: a bar on a terminal, plain lines elsewhere."""

import logging
import sys
import time
from collections.abc import Iterable, Iterator
from datetime import timedelta
from typing import TypeVar

from tqdm import tqdm

Item = TypeVar("Item")
_LINES = 10
_log = logging.getLogger(__name__)


def hide() -> None:
    """Show no progress in this process: one of many, whose progress is shown as a whole."""
    _log.setLevel(logging.WARNING)


def progress(items: Iterable[Item], total: int, label: str, initial: int = 0) -> Iterator[Item]:
    """`items` unchanged, showing on stderr how many of `total` are done, `initial` from before.

    Log level warning hides it.
    """
    if not _log.isEnabledFor(logging.INFO):
        yield from items
    elif sys.stderr.isatty():
        yield from tqdm(items, total=total, desc=label, leave=False, initial=initial)
    else:
        yield from _lines(items, total, label, initial)


def _lines(items: Iterable[Item], total: int, label: str, initial: int) -> Iterator[Item]:
    begin, shown = time.monotonic(), initial * _LINES // total
    for done, item in enumerate(items, initial + 1):
        if done * _LINES // total > shown:
            shown = done * _LINES // total
            left = (time.monotonic() - begin) / (done - initial) * (total - done)
            clock = timedelta(seconds=round(left))
            _log.info("%s: %d of %d, %s left", label, done, total, clock)
        yield item
