"""Added-mass matrix of a hull, Eqs. (22) to (26), with an error estimate for every entry.

For each mode V_j of the hull (Eq. 25)

    laplacian(phi_j) = 0,  d phi_j/dn = V_j . n on Ship, 0 on Botm,  phi_j = 0 elsewhere,

with rho phi_j the paper's p_j, whose sign is opposite to the physical pressure. By the weak form
m(i, j) = rho r_i . phi_j = rho phi_i^T K phi_j, symmetric and from below: an elliptic energy.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Literal

import numpy as np

from squat.fem import AffineStiffness, Factorised, HullLoads, Solution, Space, edge_normals
from squat.fluid.hull_modes import HullMode
from squat.mesh import Mesh
from squat.mesh.motion import Index
from squat.quantities import Vector

FreeSurface = Literal["zero_pressure", "rigid_lid"]
DIRICHLET: dict[FreeSurface, tuple[str, ...]] = {
    "zero_pressure": ("In", "Out", "FreeS"),
    "rigid_lid": ("In",),
}


@dataclass(frozen=True, eq=False)
class AddedMass:
    """Solutions of (25) on one mesh at rest or at position `q`.

    Parameters
    ----------
    mesh
        Fine mesh; its order selects P1 or P2 elements.
    free_surface
        `zero_pressure`, Eq. (23), or `rigid_lid`, Eq. (19).
    extra
        Modes beyond the mesh's rigid ones: displacement fields given on the hull.
    """

    mesh: Mesh
    free_surface: FreeSurface
    extra: Sequence[HullMode] = ()

    @cached_property
    def space(self) -> Space:
        """Finite elements on the mesh."""
        return Space.on(self.mesh)

    @property
    def names(self) -> list[str]:
        """Modes in the order of rows and columns."""
        return [*self.mesh.submesh.modes, *(mode.name for mode in self.extra)]

    @cached_property
    def loads(self) -> Vector:
        """r_j, shape (modes, size)."""
        rigid = HullLoads(self.mesh, self.space).at(self._rest)
        fields = [mode.load(self.mesh, self.space) for mode in self.extra]
        return np.vstack([rigid, *fields])

    @cached_property
    def solution(self) -> Solution:
        """Solutions of (25) for all modes, with their largest relative residual."""
        fixed = self.space.dofs(*DIRICHLET[self.free_surface])
        stiffness = AffineStiffness(self.mesh, self.space).at(self._rest)
        return Factorised.of(stiffness, fixed).solve(self.loads)

    @property
    def potentials(self) -> Vector:
        """phi_j, shape (modes, size) [m2 for translations, m3 for pitch]."""
        return self.solution.values

    @cached_property
    def matrix(self) -> Vector:
        """m(i, j)/rho, shape (modes, modes) [m2, m3, m4]."""
        product = self.loads @ self.potentials.T
        return np.asarray((product + product.T) / 2)

    def nodal_potentials(self) -> Vector:
        """phi_j at the mesh's nodes, shape (modes, nodes)."""
        return np.asarray(self.potentials[:, self.space.basis.nodal_dofs[0]])

    @property
    def _rest(self) -> Vector:
        return np.zeros(len(self.mesh.submesh.modes))


def nodal_matrix(mesh: Mesh, free_surface: FreeSurface) -> Vector:
    """[M]/rho of (26): added mass between unit displacements of single hull nodes.

    Shape (2 n, 2 n) for the n hull nodes of `hull_nodes`, x displacements first; a mode given by
    nodal values X, shape (2 n, modes), has the modal matrix X^T [M] X.
    """
    space = Space.on(mesh, 1)
    edges, nodes = mesh.boundary["Ship"], hull_nodes(mesh)
    normal = edge_normals(mesh.points[edges])
    loads = np.zeros((2, len(nodes), space.size))
    for axis in range(2):
        for place, node in enumerate(nodes):
            loads[axis, place] = space.spread("Ship", (edges == node) * normal[:, [axis]])
    flat = loads.reshape(-1, space.size)
    fixed = space.dofs(*DIRICHLET[free_surface])
    factor = Factorised.of(
        AffineStiffness(mesh, space).at(np.zeros(len(mesh.submesh.modes))), fixed
    )
    matrix = flat @ factor.solve(flat).values.T
    return np.asarray((matrix + matrix.T) / 2)


def hull_nodes(mesh: Mesh) -> Index:
    """Nodes on the hull, from the bow's water line point to the stern's."""
    edges = mesh.boundary["Ship"]
    after = dict(edges.tolist())
    first = (set(after) - set(after.values())).pop()
    chain = [first]
    while chain[-1] in after:
        chain.append(after[chain[-1]])
    return np.array(chain[::-1])  # edges have the water on their left: they run to the bow
