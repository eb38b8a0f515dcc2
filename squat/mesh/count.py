"""How many nodes a mesh will have, told before it is made."""

import numpy as np

from squat.errors import InputError
from squat.mesh.size import MeshSize
from squat.mesh.submesh import Submesh

_CORNER = np.deg2rad(30)
"""Turn of the hull's outline from which a vertex counts as a corner, to be graded to."""
_SAMPLES = 1000
_LEAST = 1e-12
"""Distances from the hull that the size of the triangles is sampled at: how many, and the least."""
_MIDPOINTS = {1: 1.0, 2: 4.0}
"""Nodes of elements of an order over vertices of their triangles."""


def corners(submesh: Submesh) -> list[int]:
    """Indices of the hull's points at which its outline turns sharply."""
    ship = submesh.boundary["Ship"]
    after = dict(ship.tolist())
    before = {b: a for a, b in after.items()}
    found = []
    for vertex in submesh.hull.tolist():
        a, b, c = submesh.rest[[before[vertex], vertex, after[vertex]]]
        angle = np.arctan2(*(c - b)[::-1]) - np.arctan2(*(b - a)[::-1])
        if abs((angle + np.pi) % (2 * np.pi) - np.pi) > _CORNER:
            found.append(vertex)
    return found


def expected_nodes(submesh: Submesh, size: MeshSize) -> float:
    """Nodes to expect, within a factor of three: 2/(sqrt(3) h^2) over the water.

    That is the density of equilateral triangles of edge h. The water at a distance d from a hull
    of perimeter P is counted as (P + pi d) dd, until the area of the channel is used up; the
    graded part around a corner as three quarters of a disc.
    """
    area = float(submesh.areas(submesh.rest).sum())
    ends = submesh.rest[submesh.boundary["Ship"]]
    perimeter = float(np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1).sum())
    reach = (np.sqrt(perimeter**2 + 2 * np.pi * area) - perimeter) / np.pi
    distance = np.concatenate([[0.0], np.geomspace(_LEAST * reach, reach, _SAMPLES)])
    h = np.minimum(size.near + size.slope * distance, size.far)
    with np.errstate(over="ignore", divide="ignore"):
        total = np.trapezoid((perimeter + np.pi * distance) / h**2, distance)
        if size.grading:
            across = np.float64(size.corner_radius) / size.near
            total += len(corners(submesh)) * 0.75 * np.pi * across**2 / (1 - size.grading)
    return float(_MIDPOINTS[size.order] * 2 / np.sqrt(3) * total)


def check_count(submesh: Submesh, size: MeshSize) -> None:
    """Raise InputError where the mesh would have more nodes than `size` allows."""
    nodes = expected_nodes(submesh, size)
    if not nodes <= size.max_nodes:
        raise InputError(
            f"mesh.near={size.near:g}: with mesh.far={size.far:g} and mesh.slope={size.slope:g} "
            f"some {nodes:.1g} nodes, more than mesh.max_nodes={size.max_nodes}; raise one of them"
        )
