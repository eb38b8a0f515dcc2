"""P1 and P2 elements on a mesh: degrees of freedom, boundaries by name, plain assembly."""

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
import skfem
from scipy import sparse

from squat.mesh import Mesh
from squat.mesh.motion import Index
from squat.quantities import Vector

ELEMENTS = {1: skfem.ElementTriP1, 2: skfem.ElementTriP2}
_EDGE_RULES = {1: np.array([[2, 1], [1, 2]]) / 6, 2: np.array([[1, 0], [0, 1], [2, 2]]) / 6}
"""int N_i (1 - t, t) dt over an edge: weights of a linear function's values at its ends."""


@skfem.BilinearForm  # type: ignore[untyped-decorator]
def laplace(u: Any, v: Any, _: Any) -> Any:
    """grad u . grad v."""
    return sum(u.grad[i] * v.grad[i] for i in range(len(u.grad)))


@dataclass(frozen=True, eq=False)
class Space:
    """Continuous elements of `order` 1 or 2 on fixed topology.

    Parameters
    ----------
    points
        Nodes (n, d) [m].
    cells
        Simplices (m, d + 1).
    boundary
        Edges (k, 2) by name.
    order
        Polynomial degree.
    """

    points: Vector
    cells: Index
    boundary: Mapping[str, Index]
    order: int

    @staticmethod
    def on(mesh: Mesh, order: int | None = None) -> "Space":
        """Space on `mesh` at rest, of the mesh's order unless another is given."""
        return Space(mesh.points, mesh.triangles, mesh.boundary, order or mesh.order)

    def at(self, points: Vector) -> "Space":
        """The same space on moved nodes (n, d): degrees of freedom keep their numbers."""
        return Space(points, self.cells, self.boundary, self.order)

    @cached_property
    def basis(self) -> Any:
        """scikit-fem's basis, with a rule exact for constant coefficients."""
        mesh = skfem.MeshTri(*(np.ascontiguousarray(a.T) for a in (self.points, self.cells)))
        return skfem.Basis(mesh, ELEMENTS[self.order](), intorder=2 * self.order - 2 or 1)

    @property
    def size(self) -> int:
        """Number of degrees of freedom."""
        return int(self.basis.N)

    @cached_property
    def dof_points(self) -> Vector:
        """Places of the degrees of freedom, shape (size, d)."""
        return np.asarray(self.basis.doflocs.T)

    def stiffness(self) -> sparse.csc_array:
        """K, int grad N_i . grad N_j, by scikit-fem's own assembly."""
        return sparse.csc_array(laplace.assemble(self.basis))

    @cached_property
    def _facets(self) -> dict[tuple[int, int], int]:
        mesh = self.basis.mesh
        outer = mesh.boundary_facets()
        return {
            (int(a), int(b)): int(f)
            for f, (a, b) in zip(outer, mesh.facets[:, outer].T, strict=True)
        }

    def edge_dofs(self, name: str) -> Index:
        """Degrees of freedom (k, 2 or 3) on each edge of a boundary: ends, then its middle."""
        edges = self.boundary[name]
        ends = self.basis.nodal_dofs[0][edges]
        if self.order == 1:
            return np.asarray(ends)
        facets = [self._facets[min(e), max(e)] for e in edges.tolist()]
        return np.column_stack([ends, self.basis.facet_dofs[0][facets]])

    def dofs(self, *names: str) -> Index:
        """Degrees of freedom on boundaries, sorted, each once: a Dirichlet set."""
        if not names:
            return np.empty(0, dtype=np.int64)
        return np.unique(np.concatenate([self.edge_dofs(name).ravel() for name in names]))

    def spread(self, name: str, ends: Vector) -> Vector:
        """int N f ds on a boundary, shape (size,), f linear on each edge.

        `ends` holds f times the edge's length at the two ends of each edge, shape (k, 2).
        """
        dofs = self.edge_dofs(name)
        values = ends @ _EDGE_RULES[self.order].T
        total = np.bincount(dofs.ravel(), values.ravel(), minlength=self.size)
        return np.asarray(total, float)
