"""Triangles between two chains that both run from bow to stern: hull above, bottom below."""

from functools import cache

import numpy as np

from squat.mesh.convex import cross
from squat.quantities import Vector

_SLACK = 0.2
"""A bottom corner this close to a hull point, over its draft, takes the place of its follower."""


def followed(x: Vector, corners: Vector, draft: float) -> list[int]:
    """Which hull points at `x` (n,) get a follower on the bottom: not those above a corner of it.

    Pitch shifts the keel along: beyond 0.2 T of shift followers may run into corners, and the
    position is refused by name.
    """
    near = np.abs(x[:, None] - corners[None]) < _SLACK * draft
    blocked = np.array(near.any(axis=1), bool)
    blocked[[0, -1]] = False
    return np.flatnonzero(~blocked).tolist()


def strip(points: Vector, hull: list[int], floor: list[int]) -> list[tuple[int, int, int]]:
    """Counterclockwise triangles between `hull` and `floor`, both bow to stern.

    Of all ways to walk along the two chains, that whose worst triangle is best.
    """
    last = len(hull) - 1, len(floor) - 1

    def shape(a: int, b: int, c: int) -> float:
        p = points[[a, b, c]]
        sides = ((p - np.roll(p, 1, axis=0)) ** 2).sum()
        return float(cross(p[0], p[1], p[2]) / sides)

    @cache
    def best(i: int, j: int) -> tuple[float, int]:
        """Worst shape from here on, and whether to step along the hull (0) or the floor (1)."""
        if (i, j) == last:
            return np.inf, 0
        options = []
        if i < last[0]:
            options.append((min(shape(floor[j], hull[i + 1], hull[i]), best(i + 1, j)[0]), 0))
        if j < last[1]:
            options.append((min(shape(floor[j], floor[j + 1], hull[i]), best(i, j + 1)[0]), 1))
        return max(options)

    triangles = []
    i = j = 0
    while (i, j) != last:
        if best(i, j)[1] == 0:
            triangles.append((floor[j], hull[i + 1], hull[i]))
            i += 1
        else:
            triangles.append((floor[j], floor[j + 1], hull[i]))
            j += 1
    return triangles
