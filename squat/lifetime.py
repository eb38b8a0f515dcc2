"""Processes that do not outlive the one that started them."""

import os
import threading
import time

_LOOK = 0.2
"""Seconds between two looks at who the parent is."""
_CLEANED = "ignore:resource_tracker"


def end_with(parent: int) -> None:
    """End this process soon after `parent`, its parent, is gone; at once where it is already.

    A killed sweep is started again with the same command: nothing of the first may still write.
    """
    threading.Thread(target=_watch, args=(parent,), daemon=True).start()


def leave_quietly() -> None:
    """Keep what cleans up after killed workers from telling of it, as the last words of a sweep."""
    said = os.environ.get("PYTHONWARNINGS", "")
    if _CLEANED not in said:
        os.environ["PYTHONWARNINGS"] = ",".join(filter(None, [said, _CLEANED]))


def _watch(parent: int) -> None:
    while os.getppid() == parent:
        time.sleep(_LOOK)
    os._exit(1)
