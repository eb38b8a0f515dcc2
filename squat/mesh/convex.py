"""Geometry behind the coarse triangulation: convex hulls and constrained triangulations."""

import numpy as np
import shapely
from shapely.geometry import Polygon

from squat.mesh.motion import Index
from squat.quantities import Vector


def cross(a: Vector, b: Vector, c: Vector) -> Vector:
    """Twice the signed area of triangles (..., 2) a, b, c; positive: counterclockwise."""
    u, v = b - a, c - a
    return np.asarray(u[..., 0] * v[..., 1] - u[..., 1] * v[..., 0])


def convex_hull(points: Vector) -> list[int]:
    """Indices of the corners of the convex hull of `points` (n, 2), counterclockwise."""
    order = np.lexsort((points[:, 1], points[:, 0]))

    def half(indices: Index) -> list[int]:
        chain: list[int] = []
        for i in indices:
            while len(chain) > 1 and cross(points[chain[-2]], points[chain[-1]], points[i]) <= 0:
                chain.pop()
            chain.append(int(i))
        return chain

    return half(order)[:-1] + half(order[::-1])[:-1]


def triangulate(points: Vector, ring: list[int]) -> list[tuple[int, int, int]]:
    """Constrained Delaunay triangles, counterclockwise, of the polygon `ring` into `points`."""
    index = {tuple(points[i]): i for i in ring}
    collection = shapely.constrained_delaunay_triangles(Polygon(points[ring]))
    triangles = []
    for part in collection.geoms:
        a, b, c = (index[tuple(corner)] for corner in part.exterior.coords[:3])
        turn = cross(points[a], points[b], points[c])
        triangles.append((a, b, c) if turn > 0 else (a, c, b))
    return triangles
