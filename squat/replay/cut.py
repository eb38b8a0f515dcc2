"""Lines cut at a frame: what lies outside is left out, nothing is moved onto the edge."""

import numpy as np

from squat.quantities import Vector


def within(points: Vector, low: Vector, high: Vector) -> Vector:
    """Which of `points` (n, 2) lie between the corners `low` and `high` (2,), edges included."""
    return np.asarray(np.all((low <= points) & (points <= high), axis=-1))


def pieces(line: Vector, low: Vector, high: Vector) -> list[Vector]:
    """Parts of `line` (n, 2) between the corners `low` and `high` (2,), up to its edges."""
    if within(line, low, high).all():
        return [line]
    start, way = line[:-1], np.diff(line, axis=0)
    enter, leave = _shares(start, way, low, high)
    seen = np.flatnonzero(enter < leave)
    if not seen.size:
        return []
    apart = (np.diff(seen) > 1) | (leave[seen[:-1]] < 1) | (enter[seen[1:]] > 0)
    first, last = start + enter[:, None] * way, start + leave[:, None] * way
    groups = np.split(seen, np.flatnonzero(apart) + 1)
    return [np.concatenate([first[group[:1]], last[group]]) for group in groups]


def _shares(start: Vector, way: Vector, low: Vector, high: Vector) -> tuple[Vector, Vector]:
    """Shares (n,) of ways (n, 2) at which they enter and leave; enter >= leave: never inside.

    Liang and Barsky, ACM Trans. Graph. 3 (1984), p. 1.
    """
    with np.errstate(divide="ignore", invalid="ignore"):
        ends = (low - start) / way, (high - start) / way
    missed = np.where((low <= start) & (start <= high), 0.0, np.inf)
    enter = np.where(way == 0, missed, np.minimum(*ends)).max(axis=1)
    leave = np.where(way == 0, 1.0, np.maximum(*ends)).min(axis=1)
    # A finite share where a way is never inside: it is multiplied, though not used.
    return np.clip(enter, 0.0, 1.0), np.clip(leave, 0.0, 1.0)
