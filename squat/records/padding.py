"""Rows of unequal length as one array."""

import numpy as np

from squat.quantities import Vector


def padded(rows: list[Vector]) -> Vector:
    """Table of shape (rows, longest), NaN where a row has ended."""
    table = np.full((len(rows), max(map(len, rows))), np.nan)
    for line, row in zip(table, rows, strict=True):
        line[: len(row)] = row
    return table
