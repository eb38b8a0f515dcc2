"""Loads of the unit motions: r_j = int_Ship V_j . n N ds, r_0 = int_Out N ds, and derivatives.

n points out of the water. V_j = dX/dq_j of a hull point: (1, 0), (0, 1), and
(-(z - z_c), x - x_c) for pitch about c. On an edge (x1, x2) with the water on its left the
length-weighted normal is ln = (z2 - z1, x1 - x2); V_j . ln is linear along the edge, so that the
integrals are exact for P1 and P2.
"""

from dataclasses import dataclass

import numpy as np

from squat.fem.space import Space
from squat.mesh import MODES, Mesh
from squat.quantities import Vector


@dataclass(frozen=True, eq=False)
class HullLoads:
    """r_j(q) and dr_j/dq_k on the hull of a moving mesh."""

    mesh: Mesh
    space: Space

    def at(self, q: Vector) -> Vector:
        """r_j(q), shape (modes, size)."""
        ends = self._ends(self.mesh.moved(q))
        fields = self._fields(ends - self.mesh.submesh.center(q))
        return np.stack([self._spread(V, edge_normals(ends)) for V in fields])

    def derivatives(self, q: Vector) -> Vector:
        """dr_j/dq_k, shape (modes j, modes k, size), exact."""
        ends = self._ends(self.mesh.moved(q))
        normal = edge_normals(ends)
        arm = ends - self.mesh.submesh.center(q)
        fields = self._fields(arm)
        out = np.zeros((len(fields), len(fields), self.space.size))
        for k, rate in enumerate(map(self._ends, self.mesh.velocities(q))):
            turning = self._fields(rate - self._center_rate(k), homogeneous=True)
            for j, (V, dV) in enumerate(zip(fields, turning, strict=True)):
                out[j, k] = self._spread(V, edge_normals(rate)) + self._spread(dV, normal)
        return out

    def _ends(self, values: Vector) -> Vector:
        """Nodal `values` (n, 2) at the ends of the hull's edges, shape (k, 2 ends, 2)."""
        return values[self.mesh.boundary["Ship"]]

    def _center_rate(self, k: int) -> Vector:
        full = self.mesh.submesh.free[k]
        return np.eye(3)[full, :2]

    def _fields(self, arm: Vector, *, homogeneous: bool = False) -> list[Vector]:
        """V_j at points `arm` (..., 2) from the centre; without its constants: dV_j of d(arm)."""
        one = 0.0 if homogeneous else 1.0
        every = {
            "surge": np.broadcast_to([one, 0.0], arm.shape),
            "heave": np.broadcast_to([0.0, one], arm.shape),
            "pitch": np.stack([-arm[..., 1], arm[..., 0]], axis=-1),
        }
        return [every[mode] for mode in MODES if mode in self.mesh.submesh.modes]

    def _spread(self, field: Vector, normal: Vector) -> Vector:
        return self.space.spread("Ship", (field * normal[:, None]).sum(axis=-1))


def flux(space: Space, name: str) -> Vector:
    """int N ds over a boundary, shape (size,): the load of unit outflow."""
    lengths = np.linalg.norm(edge_normals(space.points[space.boundary[name]]), axis=1)
    return space.spread(name, np.repeat(lengths[:, None], 2, axis=1))


def edge_normals(ends: Vector) -> Vector:
    """Length-weighted normals (k, 2) out of the water, of edges (k, 2 ends, 2)."""
    dx, dz = (ends[:, 1] - ends[:, 0]).T
    return np.stack([dz, -dx], axis=1)
