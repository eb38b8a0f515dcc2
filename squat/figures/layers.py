"""Looks of lines by which those that lie on each other are all seen, and no other stands out."""

from collections import Counter
from collections.abc import Sequence
from typing import Any

import numpy as np

from squat.figures.style import PALETTE
from squat.quantities import Vector

_WIDEST, _THINNEST = 3.6, 1.4  # pt
_DASHES = ("-", (0, (4, 3)), (0, (1, 2)))
_NEAR = 0.01  # of the picture: a line that near to another hides it
_TRIED, _DENSE = 100, 1000  # points of a line, and of that which it may lie on


def looks(curves: Sequence[Vector]) -> list[dict[str, Any]]:
    """Looks of the `curves`, each x and y (2, n), in the order in which they are drawn.

    Of those that coincide for most of their length, each is thinner than the one below, and has
    other dashes; the others are all as thin as the thinnest. No two are alike in colour and dashes,
    up to 21 of them.
    """
    drawn = [curve[:, np.isfinite(curve).all(axis=0)] for curve in curves]
    every = np.hstack(drawn)
    scale = np.ptp(every, axis=1) if every.size else np.ones(2)
    scale[scale == 0] = 1
    groups: list[list[int]] = []
    for n, curve in enumerate(drawn):
        for group in groups:
            if _hides(drawn[group[0]] / scale[:, None], curve / scale[:, None]):
                group.append(n)
                break
        else:
            groups.append([n])
    found: dict[int, dict[str, Any]] = {}
    for group in sorted(groups, key=len, reverse=True):
        found |= zip(group, _layers(len(group)), strict=True)
    return _distinct(found, groups)


def _distinct(
    given: dict[int, dict[str, Any]], groups: Sequence[Sequence[int]]
) -> list[dict[str, Any]]:
    """`given` in the order of numbers, with colours, and with dashes where they have none.

    Colours are those that were used least, by lines of the same group before all.
    """
    every = [(color, dashes) for dashes in _DASHES for color in PALETTE]
    free: list[tuple[str, Any]] = []
    place = {n: number for number, group in enumerate(groups) for n in group}
    used: Counter[Any] = Counter()
    told = {}
    for n, look in given.items():
        free = free or every.copy()
        fitting = [pair for pair in free if pair[1] == look.get("ls", pair[1])] or free
        color, dashes = min(fitting, key=lambda pair: (used[place[n], pair[0]], used[pair[0]]))
        free.remove((color, dashes))
        used.update([color, (place[n], color)])
        told[n] = {**look, "color": color, "ls": dashes}
    return [told[n] for n in sorted(told)]


def _hides(below: Vector, above: Vector) -> bool:
    """Whether most of the shorter of two curves (2, n), scaled to the picture, is on the other.

    A point, which is drawn as a ring, hides but another one.
    """
    least, most = sorted((below.shape[1], above.shape[1]))
    if least == 0 or least == 1 < most:
        return False
    return max(_share(below, above), _share(above, below)) > 0.5


def _share(line: Vector, other: Vector) -> float:
    """The share of a curve's points that are near to another curve."""
    tried, dense = _spread(line, _TRIED), _spread(other, _DENSE)
    away = np.hypot(*(tried[:, :, None] - dense[:, None])).min(axis=1)
    return float(np.mean(away < _NEAR))


def _spread(curve: Vector, count: int) -> Vector:
    """`count` points along a curve, by the numbers of its own."""
    number = np.linspace(0, curve.shape[1] - 1, count)
    return np.stack([np.interp(number, np.arange(curve.shape[1]), part) for part in curve])


def _layers(count: int) -> list[dict[str, Any]]:
    """Looks of `count` lines on each other; a single one may have any dashes."""
    if count == 1:
        return [{"lw": _THINNEST}]
    step = (_WIDEST - _THINNEST) / (count - 1)
    return [
        {"lw": _THINNEST + step * (count - 1 - line), "ls": _DASHES[line % len(_DASHES)]}
        for line in range(count)
    ]
