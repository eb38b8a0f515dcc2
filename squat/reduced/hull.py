"""Integrated pressure in reduced coordinates: nothing of the mesh's size is left.

With x the coordinates of the potential in the basis, lambda_l the linear function that is 1 at
end l of a coarse hull edge and 0 at the other, and t in (0, 1) along the edge, F_i = sum_l f_il p_l
with f_il = V_i . N at end l and the moments

    p_l = int (p - p_atm) lambda_l dt = rho [g h_l + V^2/4 - sum_ab M_ab x.Q_lab x / 2
                                             + sum_ea c_ea R_lea . x - S_l . dx/dt]

h_l is that of H - z; M = (D^T D)^-1 and c_e = D^-1 V_mesh(e) belong to the zone beside the edge, D
its deformation. Q, R and S are constant, so the form is exact (docs/theory/reduced.md).
"""

from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np

from squat.fem.affine import flat
from squat.fluid.model import Coefficients, Flow
from squat.fluid.pressure import GAUSS, beside, gradients
from squat.mesh import Mesh
from squat.mesh.motion import Index
from squat.quantities import Vector
from squat.reduced.fluid import ReducedFluid
from squat.reduced.model import ReducedModel
from squat.water import Water

_LINEAR = np.array([[1 / 3, 1 / 6], [1 / 6, 1 / 3]])
"""int lambda_l lambda_e dt."""


class HullForm(NamedTuple):
    """The constant matrices, of k coarse hull edges and N basis functions of all systems.

    quadratic
        Q, entries ab = 00, 01 + 10, 11; shape (k, 2 ends l, 3, N, N).
    linear
        R, shape (k, 2 ends l, 2 ends e, 2, N).
    load
        S, shape (k, 2 ends l, N).
    """

    quadratic: Vector
    linear: Vector
    load: Vector

    @staticmethod
    def of(mesh: Mesh, basis: tuple[Vector, ...]) -> "HullForm":
        """From basis functions (N, nodes) of each system on a mesh of what lies beside the hull."""
        values, fine = np.vstack(basis), mesh.boundary["Ship"]
        cells = mesh.triangles[beside(mesh)]
        slopes = np.stack([gradients(mesh.points[cells], v[cells]) for v in values], axis=-1)
        ends = mesh.weights[fine.ravel()].toarray().reshape(len(fine), 2, -1)
        parts = []
        for pair in mesh.submesh.boundary["Ship"]:
            on = ~np.delete(ends, pair, axis=2).any(axis=(1, 2))
            parts.append(_edge(ends[on][:, :, pair], slopes[on], values[:, fine[on]]))
        return HullForm(*map(np.array, zip(*parts, strict=True)))


def _edge(ends: Vector, slopes: Vector, values: Vector) -> tuple[Vector, Vector, Vector]:
    """Q, R, S of one coarse edge, by the two Gauss points of `HullPressure` on each fine edge.

    Parameters
    ----------
    ends
        lambda at both ends of the fine edges, shape (fine, 2 ends, 2 l).
    slopes
        Gradients of the basis functions beside them at q = 0, shape (fine, 2, N).
    values
        Basis functions at their ends, shape (N, fine, 2).
    """
    weight = (ends[:, 1, 1] - ends[:, 0, 1]) / 2  # a coarse edge's length counts as 1
    at_points = GAUSS @ ends
    once = weight[:, None] * at_points.sum(axis=1)
    twice = weight[:, None, None] * (at_points.swapaxes(1, 2) @ at_points)
    spread = np.einsum("k,kpl,pe->lke", weight, at_points, GAUSS)
    products = [
        [
            _gram(part * 2 ** (a != b), slopes[:, a], slopes[:, b])
            for a, b in ((0, 0), (0, 1), (1, 1))
        ]
        for part in once.T
    ]
    linear = np.einsum("kle,kan->lean", twice, slopes)
    return np.array(products), linear, np.einsum("lke,nke->ln", spread, values)


def _gram(weight: Vector, left: Vector, right: Vector) -> Vector:
    """sum_k weight_k left_k right_k^T, its symmetric part, shape (N, N)."""
    product = (weight[:, None] * left).T @ right
    return np.asarray((product + product.T) / 2)


@dataclass(frozen=True, eq=False)
class HullFluid:
    """A `FluidModel` whose potentials are coordinates x (N,) in the basis of a reduced model."""

    model: ReducedModel
    form: HullForm
    water: Water
    current: float

    @staticmethod
    def of(fluid: ReducedFluid) -> "HullFluid":
        """The same fluid, its basis functions integrated along the hull."""
        form = HullForm.of(fluid.mesh, fluid.basis)
        return HullFluid(fluid.model, form, fluid.water, fluid.current)

    def flow(self, position: Vector, velocity: Vector) -> Flow:
        """Coordinates for hull position and velocity, (n,) each; PositionError out of the box."""
        speeds = np.concatenate([[self.current], velocity])
        return Flow(position, velocity, speeds @ self.units(position))

    def unit_potentials(self, position: Vector) -> tuple[Vector, Vector]:
        """Coordinates (N,) of the flow of unit current and (n, N) of those of unit velocities."""
        units = self.units(position)
        return units[0], units[1:]

    def force(self, flow: Flow, rate: Vector) -> Vector:
        """Generalised force (n,) of p - p_atm, given d phi/dt at the moving nodes as dx/dt (N,)."""
        return np.asarray(self._loads(flow.position) @ self.moments(flow, rate).ravel())

    def coefficients(self, position: Vector) -> Coefficients:
        """Energy coefficients a, b, c at `position`."""
        return self.model.coefficients(position)

    def moments(self, flow: Flow, rate: Vector) -> Vector:
        """p_l [Pa] of every coarse hull edge, shape (k, 2 ends)."""
        submesh, (quadratic, linear, load) = self.model.submesh, self.form
        vertices, x = submesh.positions(flow.position), flow.potential
        inverse = self._rest_sides @ np.linalg.inv(self._sides(vertices))  # D^-1
        carried = np.tensordot(flow.velocity, submesh.first(flow.position), axes=1)[self._hull]
        metric = flat(inverse[:, None] @ inverse[:, None].swapaxes(-1, -2))
        speed = (metric[:, None] * (quadratic @ x @ x)).sum(axis=2)
        moving = ((carried @ inverse.swapaxes(1, 2))[:, None] * (linear @ x)).sum(axis=(2, 3))
        head = self.water.gravity * (submesh.limits.level - vertices[self._hull][..., 1]) @ _LINEAR
        steady = head + self.current**2 / 4 - speed / 2
        return np.asarray(self.water.density * (steady + moving - load @ rate))

    def impulses(self, position: Vector) -> Vector:
        """int phi V_i . n ds of every basis function, shape (n, N)."""
        return self._loads(position) @ self.form.load.reshape(-1, self.form.load.shape[-1])

    def units(self, position: Vector) -> Vector:
        """Coordinates of all unit flows, shape (1 + n, N)."""
        found = self.model.solve(position).u
        units = np.zeros((1 + len(position), self.form.load.shape[-1]))
        begin = 0
        for system, u in zip(self.model.systems, found, strict=True):
            units[system.flows, begin : begin + system.size] = u
            begin += system.size
        return units

    def _loads(self, position: Vector) -> Vector:
        """f (n, 2 k): what the moments do to the modes."""
        return self.model.solve(position).at.loads[1:, 1:]

    @property
    def _hull(self) -> Index:
        return self.model.submesh.boundary["Ship"]

    @cached_property
    def _beside(self) -> Index:
        """Coarse triangle with each of the hull's coarse edges, shape (k, 3)."""
        triangles = self.model.submesh.triangles
        return triangles[[np.isin(triangles, edge).sum(axis=1).argmax() for edge in self._hull]]

    @cached_property
    def _rest_sides(self) -> Vector:
        return self._sides(self.model.submesh.rest)

    def _sides(self, vertices: Vector) -> Vector:
        """Two sides of the coarse triangles beside the hull as columns, shape (k, 2, 2)."""
        corners = vertices[self._beside]
        return (corners[:, 1:] - corners[:, :1]).swapaxes(1, 2)
