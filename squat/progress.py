"""Progress of long work: a bar on a terminal, plain lines elsewhere."""

import logging
import sys
from collections.abc import Iterable, Iterator
from typing import TypeVar

from tqdm import tqdm

Item = TypeVar("Item")
_LINES = 10
_log = logging.getLogger(__name__)


def progress(items: Iterable[Item], total: int, label: str) -> Iterator[Item]:
    """`items` unchanged, showing on stderr how many of `total` are done."""
    if sys.stderr.isatty():
        yield from tqdm(items, total=total, desc=label, leave=False)
        return
    shown = 0
    for done, item in enumerate(items, 1):
        if done * _LINES // total > shown:
            shown = done * _LINES // total
            _log.info("%s: %d of %d", label, done, total)
        yield item
