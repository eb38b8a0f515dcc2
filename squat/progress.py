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


def _any(_: object) -> bool:
    return True


def hide() -> None:
    """Show no progress in this process: one of many, whose progress is shown as a whole."""
    _log.setLevel(logging.WARNING)


def progress(
    items: Iterable[Item],
    total: int,
    label: str,
    initial: int = 0,
    note: Callable[[], str] = str,
    worked: Callable[[Item], bool] = _any,
    log: logging.Logger = _log,
) -> Iterator[Item]:
    """`items` unchanged, showing on stderr how many of `total` are done.

    Parameters
    ----------
    initial
        How many were done before.
    note
        What else to say, asked after each item.
    worked
        Whether an item took any work: one that did not tells nothing of the time left.
    log
        Its level warning hides all.
    """
    if not log.isEnabledFor(logging.INFO):
        yield from items
    elif sys.stderr.isatty():
        yield from _bar(items, total, label, initial, note, worked)
    else:
        yield from _lines(items, total, label, initial, note, worked, log)


def _bar(
    items: Iterable[Item],
    total: int,
    label: str,
    initial: int,
    note: Callable[[], str],
    worked: Callable[[Item], bool],
) -> Iterator[Item]:
    # Without smoothing tqdm's rate is that of all items beyond `initial`.
    with tqdm(total=total, desc=label, leave=False, initial=initial, smoothing=0) as bar:
        for item in items:
            yield item
            bar.initial += not worked(item)
            bar.set_postfix_str(note(), refresh=False)
            bar.update()


def _lines(
    items: Iterable[Item],
    total: int,
    label: str,
    initial: int,
    note: Callable[[], str],
    worked: Callable[[Item], bool],
    log: logging.Logger,
) -> Iterator[Item]:
    begin, shown, works = time.monotonic(), initial * _LINES // max(total, 1), 0
    for done, item in enumerate(items, initial + 1):
        yield item
        works += worked(item)
        if done * _LINES // total > shown:
            shown = done * _LINES // total
            words = [f"{label}: {done} of {total}", note()]
            if done < total and works:
                left = (time.monotonic() - begin) / works * (total - done)
                words.append(f"{timedelta(seconds=round(left))} left")
            log.info("%s", ", ".join(filter(None, words)))
