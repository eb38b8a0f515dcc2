"""Loads of the unit motions: r_j = int_Ship V_j . n N ds, r_0 = int_Out N ds, and derivatives.

n points out of the water. V_j = dX/dq_j of a hull point: (1, 0), (0, 1), and
(-(z - z_c), x - x_c) for pitch about c. A coarse edge of the hull from A to B has the normal
N = (z_B - z_A, x_A - x_B) by length, and V_j . N is linear along it. So the loads are affine too,

    r_j(q) = sum_edges V_j(A) . N s_A + V_j(B) . N s_B

with constant s_A, s_B: the integrals of the shape functions against 1 - t and t along the edge,
exact for P1 and P2.
"""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from squat.fem.space import Space
from squat.mesh import MODES, Mesh, Submesh
from squat.quantities import Vector


@dataclass(frozen=True, eq=False)
class EdgeLoads:
    """Coefficients V_j . N at both ends of each coarse edge of the hull; no fine mesh needed."""

    submesh: Submesh

    @property
    def terms(self) -> int:
        """Number of coefficients of one load: two an edge."""
        return 2 * len(self.submesh.boundary["Ship"])

    def at(self, q: Vector) -> Vector:
        """Coefficients of r_j(q), shape (modes, terms)."""
        ends = self._ends(self.submesh.positions(q))
        normal = edge_normals(ends)
        return np.stack([_product(V, normal) for V in self._fields(ends - self.submesh.center(q))])

    def derivatives(self, q: Vector) -> Vector:
        """Coefficients of dr_j/dq_k, shape (modes j, modes k, terms), exact."""
        ends = self._ends(self.submesh.positions(q))
        normal = edge_normals(ends)
        fields = self._fields(ends - self.submesh.center(q))
        out = np.zeros((len(fields), len(fields), self.terms))
        for k, rate in enumerate(map(self._ends, self.submesh.first(q))):
            turning = self._fields(rate - self._center_rate(k), homogeneous=True)
            for j, (V, dV) in enumerate(zip(fields, turning, strict=True)):
                out[j, k] = _product(V, edge_normals(rate)) + _product(dV, normal)
        return out

    def _ends(self, values: Vector) -> Vector:
        """`values` (nc, 2) of the coarse vertices at the ends of the edges, (k, 2 ends, 2)."""
        return values[self.submesh.boundary["Ship"]]

    def _center_rate(self, k: int) -> Vector:
        full = self.submesh.free[k]
        return np.eye(3)[full, :2]

    def _fields(self, arm: Vector, *, homogeneous: bool = False) -> list[Vector]:
        """V_j at points `arm` (..., 2) from the centre; without its constants: dV_j of d(arm)."""
        one = 0.0 if homogeneous else 1.0
        every = {
            "surge": np.broadcast_to([one, 0.0], arm.shape),
            "heave": np.broadcast_to([0.0, one], arm.shape),
            "pitch": np.stack([-arm[..., 1], arm[..., 0]], axis=-1),
        }
        return [every[mode] for mode in MODES if mode in self.submesh.modes]


@dataclass(frozen=True, eq=False)
class HullLoads:
    """r_j(q) and dr_j/dq_k on the hull of a moving mesh."""

    mesh: Mesh
    space: Space

    @cached_property
    def edges(self) -> EdgeLoads:
        """Coefficients of the affine form."""
        return EdgeLoads(self.mesh.submesh)

    @cached_property
    def terms(self) -> Vector:
        """The constant loads s_A, s_B of each coarse edge in turn, shape (terms, size)."""
        weights = self.mesh.weights[self.mesh.boundary["Ship"].ravel()].toarray()
        ends = weights.reshape(-1, 2, weights.shape[1])  # (edges, 2 ends, coarse vertices)
        rows = []
        for pair in self.mesh.submesh.boundary["Ship"]:
            on = ~np.delete(ends, pair, axis=2).any(axis=(1, 2))
            part = on * (ends[:, 1, pair[1]] - ends[:, 0, pair[1]])  # of the edge's length
            rows += [self.space.spread("Ship", part[:, None] * ends[:, :, c]) for c in pair]
        return np.array(rows)

    def at(self, q: Vector) -> Vector:
        """r_j(q), shape (modes, size)."""
        # One by one: a load does not depend, in its last bit, on which other modes there are.
        return np.stack([row @ self.terms for row in self.edges.at(q)])

    def derivatives(self, q: Vector) -> Vector:
        """dr_j/dq_k, shape (modes j, modes k, size), exact."""
        return np.asarray(self.edges.derivatives(q) @ self.terms)


def _product(field: Vector, normal: Vector) -> Vector:
    """V . N at both ends of each edge, shape (2 k,)."""
    return np.asarray((field * normal[:, None]).sum(axis=-1).ravel())


def flux(space: Space, name: str) -> Vector:
    """int N ds over a boundary, shape (size,): the load of unit outflow."""
    lengths = np.linalg.norm(edge_normals(space.points[space.boundary[name]]), axis=1)
    return space.spread(name, np.repeat(lengths[:, None], 2, axis=1))


def edge_normals(ends: Vector) -> Vector:
    """Length-weighted normals (k, 2) out of the water, of edges (k, 2 ends, 2)."""
    dx, dz = (ends[:, 1] - ends[:, 0]).T
    return np.array([dz, -dx]).T.copy()  # asked for at every step: a third of np.stack's time
