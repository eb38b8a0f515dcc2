"""Potential flow around the moving hull, Eqs. (18) to (21), and its force on the hull, Eq. (15)."""

from dataclasses import dataclass, replace
from functools import cached_property
from typing import Literal

import numpy as np

from squat.errors import InputError
from squat.fem import AffineStiffness, HullLoads, Space, flux
from squat.fluid.added_mass import DIRICHLET
from squat.fluid.model import Coefficients, Flow
from squat.fluid.pressure import HullPressure
from squat.fluid.stiffness import MovingSolver
from squat.mesh import Mesh
from squat.quantities import Vector
from squat.water import Water

FreeSurface = Literal["rigid_lid", "zero_pressure", "blend"]
_EVALUABLE = 0.002
"""Clearance over that at rest, below which not even an iterate is evaluated."""


@dataclass(eq=False)
class PotentialFluid:
    """Potential flow in a channel whose current is `current` [m/s] far from the hull.

    Parameters
    ----------
    mesh
        P1 mesh with the modes of the motion.
    free_surface
        `rigid_lid`, Eq. (19); `zero_pressure`, Eq. (23), without current only; `blend`: the
        current's potential under the lid, the hull's with zero pressure, their cross term dropped.
    """

    mesh: Mesh
    water: Water
    free_surface: FreeSurface
    current: float

    def __post_init__(self) -> None:
        if self.free_surface == "zero_pressure" and self.current != 0:
            raise InputError(
                f"free_surface=zero_pressure: no current={self.current:g} reaches the hull under "
                "it; give rigid_lid, blend, or current=0"
            )
        if self.mesh.order != 1:
            raise InputError(f"mesh.order={self.mesh.order}: pressure is integrated on P1; give 1")
        limits = replace(self.mesh.submesh.limits, fraction=_EVALUABLE)
        self.mesh = replace(self.mesh, submesh=replace(self.mesh.submesh, limits=limits))

    @cached_property
    def space(self) -> Space:
        """Finite elements on the mesh."""
        return Space.on(self.mesh)

    @cached_property
    def _affine(self) -> AffineStiffness:
        return AffineStiffness(self.mesh, self.space)

    @cached_property
    def _loads(self) -> HullLoads:
        return HullLoads(self.mesh, self.space)

    @cached_property
    def inflow(self) -> Vector:
        """r_0: load of unit flux through Out."""
        return flux(self.space, "Out")

    @cached_property
    def _lid(self) -> MovingSolver:
        return MovingSolver(self._affine, self.space.dofs(*DIRICHLET["rigid_lid"]))

    @cached_property
    def _motion(self) -> MovingSolver:
        if self.free_surface == "rigid_lid":
            return self._lid
        return MovingSolver(self._affine, self.space.dofs(*DIRICHLET["zero_pressure"]))

    @cached_property
    def pressure(self) -> HullPressure:
        """Pressure on the hull and its generalised force."""
        return HullPressure(self.mesh, self.water)

    def flow(self, position: Vector, velocity: Vector) -> Flow:
        """Potential for hull position and velocity, shape (n,) each.

        Raises
        ------
        PositionError
            Where the mesh cannot follow.
        """
        theta = self._affine.theta(position)
        moving = velocity @ self._loads.at(position)
        if self.free_surface == "rigid_lid":
            load = self.current * self.inflow + moving
            potential = self._lid.solve(theta, load)
        else:
            potential = self._motion.solve(theta, moving)
            if self.current:
                potential += self._lid.solve(theta, self.current * self.inflow)
        return Flow(position, velocity, potential)

    def force(self, flow: Flow, rate: Vector) -> Vector:
        """Generalised force (n,) [N/m] of p - p_atm, given d phi/dt at the nodes, Eq. (15)."""
        return self.pressure.force(flow, rate, self.current)

    def unit_potentials(self, position: Vector) -> tuple[Vector, Vector]:
        """phi_0 (nodes,) of unit current and phi_j (n, nodes) of unit velocities."""
        theta = self._affine.theta(position)
        current = self._lid.solve(theta, self.inflow)
        unit = [self._motion.solve(theta, load) for load in self._loads.at(position)]
        return current, np.array(unit)

    def coefficients(self, position: Vector) -> Coefficients:
        """Energy coefficients a, b, c at `position`."""
        rho, loads = self.water.density, self._loads.at(position)
        current, unit = self.unit_potentials(position)
        c = rho * loads @ unit.T
        b = rho * loads @ current if self.free_surface == "rigid_lid" else np.zeros(len(loads))
        return Coefficients(rho * float(self.inflow @ current), b, (c + c.T) / 2)
