"""Progress of long work: a bar on a terminal, plain lines elsewhere."""

import logging
import sys
import time
from collections.abc import Callable, Iterable, Iterator
from datetime import timedelta
from typing import TypeVar

from tqdm import tqdm

Item = TypeVar("Item")
_LINES = 10
_log = logging.getLogger(__name__)


def hide() -> None:
    """Show no progress in this process: one of many, whose progress is shown as a whole."""
    _log.setLevel(logging.WARNING)


def progress(
    items: Iterable[Item],
    total: int,
    label: str,
    initial: int = 0,
    note: Callable[[], str] = str,
    log: logging.Logger = _log,
) -> Iterator[Item]:
    """`items` unchanged, showing on stderr how many of `total` are done.

    Parameters
    ----------
    initial
        How many were done before.
    note
        What else to say, asked after each item.
    log
        Its level warning hides all.
    """
    if not log.isEnabledFor(logging.INFO):
        yield from items
    elif sys.stderr.isatty():
        yield from _bar(items, total, label, initial, note)
    else:
        yield from _lines(items, total, label, initial, note, log)


def _bar(
    items: Iterable[Item], total: int, label: str, initial: int, note: Callable[[], str]
) -> Iterator[Item]:
    with tqdm(total=total, desc=label, leave=False, initial=initial) as bar:
        for item in items:
            yield item
            bar.set_postfix_str(note(), refresh=False)
            bar.update()


def _lines(
    items: Iterable[Item],
    total: int,
    label: str,
    initial: int,
    note: Callable[[], str],
    log: logging.Logger,
) -> Iterator[Item]:
    begin, shown = time.monotonic(), initial * _LINES // total
    for done, item in enumerate(items, initial + 1):
        yield item
        if done * _LINES // total > shown:
            shown = done * _LINES // total
            left = (time.monotonic() - begin) / (done - initial) * (total - done)
            words = [f"{label}: {done} of {total}", note()]
            if done < total:
                words.append(f"{timedelta(seconds=round(left))} left")
            log.info("%s", ", ".join(filter(None, words)))
