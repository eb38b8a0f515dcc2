"""Shape of triangles."""

import numpy as np

from squat.mesh.convex import cross
from squat.mesh.motion import Index
from squat.quantities import Vector


def quality(points: Vector, triangles: Index) -> Vector:
    """4 sqrt(3) area over the sum of squared sides, (m,): 1 equilateral, 0 flat, < 0 inverted."""
    a, b, c = (points[i] for i in triangles.T)
    squares = sum(((u - v) ** 2).sum(axis=1) for u, v in ((a, b), (b, c), (c, a)))
    return np.asarray(2 * np.sqrt(3) * cross(a, b, c) / squares)


def smallest_angle(points: Vector, triangles: Index) -> Vector:
    """Smallest angle [degrees] of each triangle, (m,)."""
    corners = points[triangles]
    angles = []
    for k in range(3):
        u, v = (corners[:, (k + i) % 3] - corners[:, k] for i in (1, 2))
        angles.append(
            np.arctan2(np.abs(u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0]), (u * v).sum(axis=1))
        )
    return np.asarray(np.rad2deg(np.min(angles, axis=0)))
