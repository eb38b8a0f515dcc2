"""Independent work over the cores, by processes that do not outlive this one."""

import os
from collections.abc import Callable, Iterable
from typing import Any, TypeVar

from joblib import Parallel, delayed

from squat.lifetime import end_with, leave_quietly
from squat.progress import progress

Answer = TypeVar("Answer")


def spread(
    function: Callable[..., Answer],
    arguments: Iterable[tuple[Any, ...]],
    label: str,
    cost: Callable[..., float] | None = None,
) -> list[Answer]:
    """`function(*one)` for each one of `arguments`, in their order.

    Parameters
    ----------
    label
        Of the progress.
    cost
        `cost(*one)` tells which one takes longest: it starts first.
    """
    given = list(arguments)
    order = list(range(len(given)))
    if cost is not None:
        order.sort(key=lambda i: -cost(*given[i]))
    leave_quietly()
    over = Parallel(n_jobs=-1, return_as="generator", initializer=end_with, initargs=(os.getpid(),))
    results = over(delayed(function)(*given[i]) for i in order)
    found = dict(zip(order, progress(results, len(given), label), strict=True))
    return [found[i] for i in range(len(given))]
