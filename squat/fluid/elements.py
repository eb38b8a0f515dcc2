"""Finite elements of the water around a hull: stiffness and loads wherever the hull is."""

from dataclasses import dataclass
from functools import cached_property

from squat.fem import AffineStiffness, HullLoads, Space, flux
from squat.mesh import Mesh
from squat.quantities import Vector


@dataclass(eq=False)
class Elements:
    """What every flow solver on a mesh has, each made when it is first asked for.

    Parameters
    ----------
    mesh
        With the modes of the motion.
    """

    mesh: Mesh

    @cached_property
    def space(self) -> Space:
        """Finite elements on the mesh."""
        return Space.on(self.mesh)

    @cached_property
    def inflow(self) -> Vector:
        """r_0: load of unit flux through Out."""
        return flux(self.space, "Out")

    @cached_property
    def _affine(self) -> AffineStiffness:
        return AffineStiffness(self.mesh, self.space)

    @cached_property
    def _loads(self) -> HullLoads:
        return HullLoads(self.mesh, self.space)
