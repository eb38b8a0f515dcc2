"""The triangles beside the hull: all that the pressure on it needs."""

from dataclasses import replace
from typing import NamedTuple

import numpy as np

from squat.fluid.pressure import beside
from squat.mesh import Mesh
from squat.mesh.motion import Index


class Patch(NamedTuple):
    """A mesh of the triangles beside the hull, and its nodes' numbers in the whole mesh."""

    mesh: Mesh
    nodes: Index


def hull_patch(mesh: Mesh) -> Patch:
    """The patch of `mesh`; it moves as the mesh does, and `HullPressure` works on it."""
    cells = np.unique(beside(mesh))
    nodes, triangles = np.unique(mesh.triangles[cells], return_inverse=True)
    boundary = {name: np.empty((0, 2), dtype=np.int64) for name in mesh.boundary}
    boundary["Ship"] = np.searchsorted(nodes, mesh.boundary["Ship"])
    patch = replace(
        mesh,
        points=mesh.points[nodes],
        triangles=triangles.reshape(-1, 3),
        zone=mesh.zone[cells],
        boundary=boundary,
    )
    return Patch(patch, nodes)
