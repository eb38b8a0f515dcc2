"""Unsteady pressure on the moving hull, Eqs. (20) and (21), and its integrals."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from scipy import sparse

from squat.fem import edge_normals
from squat.fluid.added_mass import hull_nodes
from squat.fluid.model import Flow
from squat.mesh import Mesh
from squat.mesh.motion import Index
from squat.quantities import Vector
from squat.water import Water

# Two Gauss points an edge: exact for the product of two linear functions.
_POINTS = 0.5 + np.array([-0.5, 0.5]) / np.sqrt(3)
GAUSS = np.stack([1 - _POINTS, _POINTS], axis=1)
"""The linear functions of an edge's ends at its Gauss points, shape (2 points, 2 ends)."""


@dataclass(frozen=True, eq=False)
class HullPressure:
    """Pressure on the hull's edges from P1 potentials: grad phi is constant beside each edge."""

    mesh: Mesh
    water: Water

    @cached_property
    def edges(self) -> Index:
        """Nodes (k, 2) of the hull's edges, the water on their left."""
        return self.mesh.boundary["Ship"]

    @cached_property
    def beside(self) -> Index:
        """Nodes (k, 3) of the triangle beside each edge."""
        return np.asarray(self.mesh.triangles[beside(self.mesh)])

    @cached_property
    def _weights(self) -> tuple[sparse.csr_array, sparse.csr_array]:
        """From coarse vertices to the edges' ends and to the corners of the triangles beside."""
        weights = self.mesh.weights
        return weights[self.edges.ravel()], weights[self.beside.ravel()]

    @cached_property
    def nodes(self) -> Index:
        """Nodes on the hull, from the bow's water line point to the stern's."""
        return hull_nodes(self.mesh)

    def at_points(self, flow: Flow, rate: Vector, current: float) -> tuple[Vector, Vector, Vector]:
        """Pressure less p_atm (k, 2) [Pa], the edges' ends (k, 2, 2), normals by length (k, 2)."""
        submesh, (at_ends, at_corners) = self.mesh.submesh, self._weights
        vertices = submesh.positions(flow.position)
        rates = np.tensordot(flow.velocity, submesh.first(flow.position), axes=1)
        corners = (at_corners @ vertices).reshape(-1, 3, 2)
        gradient = gradients(corners, flow.potential[self.beside])
        ends = (at_ends @ vertices).reshape(-1, 2, 2)
        mesh_velocity = (at_ends @ rates).reshape(-1, 2, 2)
        carried = (mesh_velocity * gradient[:, None]).sum(axis=2)
        unsteady = (rate[self.edges] - carried) @ GAUSS.T
        rho, g = self.water.density, self.water.gravity
        speed = (gradient**2).sum(axis=1)
        head = g * (self.mesh.submesh.limits.level - ends[..., 1] @ GAUSS.T)
        pressure = rho * (head + (current**2 - speed[:, None]) / 2 - unsteady)
        return pressure, ends, edge_normals(ends)

    def force(self, flow: Flow, rate: Vector, current: float) -> Vector:
        """Integral of (p - p_atm) V_i . n over the hull, shape (n,) [N/m]."""
        pressure, ends, normal = self.at_points(flow, rate, current)
        along = normal * (pressure.sum(axis=1) / 2)[:, None]
        parts = {"surge": along[:, 0].sum(), "heave": along[:, 1].sum()}
        if "pitch" in self.mesh.submesh.modes:
            arm = GAUSS @ (ends - self.mesh.submesh.center(flow.position))
            turning = arm[..., 0] * normal[:, [1]] - arm[..., 1] * normal[:, [0]]
            parts["pitch"] = (pressure * turning).sum() / 2
        return np.array([parts[mode] for mode in self.mesh.submesh.modes])

    def nodal(self, flow: Flow, rate: Vector, current: float) -> Vector:
        """Pressure less p_atm at `nodes`: mean of the edges that meet there [Pa]."""
        pressure, _, _ = self.at_points(flow, rate, current)
        # The linear function through both Gauss points, at the edge's ends.
        ends = pressure @ np.linalg.inv(GAUSS).T
        size = len(self.mesh.points)
        total = np.bincount(self.edges.ravel(), ends.ravel(), minlength=size)
        count = np.bincount(self.edges.ravel(), minlength=size)
        return np.asarray(total[self.nodes] / count[self.nodes])


def beside(mesh: Mesh) -> Index:
    """The triangle (k,) beside each edge of the hull."""
    sides = np.concatenate([mesh.triangles[:, [i, (i + 1) % 3]] for i in range(3)])
    key = sides @ [len(mesh.points), 1]
    order = np.argsort(key)
    edges = mesh.boundary["Ship"] @ [len(mesh.points), 1]
    return np.asarray(order[np.searchsorted(key[order], edges)] % len(mesh.triangles))


def gradients(corners: Vector, values: Vector) -> Vector:
    """Gradient (k, 2) of the linear function with `values` (k, 3) at `corners` (k, 3, 2)."""
    (ax, az), (bx, bz) = ((corners[:, i] - corners[:, 0]).T for i in (1, 2))
    da, db = values[:, 1] - values[:, 0], values[:, 2] - values[:, 0]
    area = ax * bz - az * bx
    return np.stack([(da * bz - db * az) / area, (db * ax - da * bx) / area], axis=1)
