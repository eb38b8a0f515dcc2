"""Potential flow around the moving hull, Eqs. (18) to (21), and its force on the hull, Eq. (15)."""

from dataclasses import dataclass, field, replace
from functools import cached_property

import numpy as np

from squat.errors import InputError
from squat.fluid.added_mass import DIRICHLET
from squat.fluid.elements import Elements
from squat.fluid.model import Coefficients, Flow, FreeSurface, Slopes, check_current
from squat.fluid.pressure import HullPressure
from squat.fluid.stiffness import MovingSolver
from squat.fluid.variational import UnitFlows
from squat.quantities import Vector
from squat.water import Water

_EVALUABLE = 0.002
"""Clearance over that at rest, below which not even an iterate is evaluated."""


@dataclass(eq=False)
class PotentialFluid(Elements):
    """Potential flow in a channel whose current is `current` [m/s] far from the hull.

    Parameters
    ----------
    mesh
        P1 mesh with the modes of the motion.
    free_surface
        `rigid_lid`, Eq. (19); `zero_pressure`, Eq. (23), without current only; `blend`: the
        current's potential under the lid, the hull's with zero pressure, their cross term dropped.
    """

    water: Water
    free_surface: FreeSurface
    current: float
    _last: UnitFlows | None = field(default=None, init=False, repr=False)

    def __post_init__(self) -> None:
        check_current(self.free_surface, self.current)
        if self.mesh.order != 1:
            raise InputError(f"mesh.order={self.mesh.order}: pressure is integrated on P1; give 1")
        limits = replace(self.mesh.submesh.limits, fraction=_EVALUABLE)
        self.mesh = replace(self.mesh, submesh=replace(self.mesh.submesh, limits=limits))

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

    def forget(self) -> None:
        """Answer from now on as a new object would: no kept factor, no recent solutions."""
        self._last = None
        self._lid.forget()
        self._motion.forget()

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
        flows = self.unit_flows(position)
        return flows.current, flows.unit

    def unit_flows(self, position: Vector) -> UnitFlows:
        """Flows of unit speed at `position`, kept for the last one asked for.

        Raises
        ------
        PositionError
            Where the mesh cannot follow.
        """
        last = self._last
        if last is None or not np.array_equal(last.position, position):
            theta, loads = self._affine.theta(position), self._loads.at(position)
            current = self._lid.solve(theta, self.inflow)
            unit = np.array([self._motion.solve(theta, load) for load in loads])
            last = self._last = UnitFlows(np.array(position), theta, loads, current, unit)
        return last

    @property
    def _crossed(self) -> bool:
        """Whether current and hull motion share one free surface: b = 0 otherwise."""
        return self.free_surface == "rigid_lid"

    def coefficients(self, position: Vector) -> Coefficients:
        """Energy coefficients a, b, c at `position`."""
        flows = self.unit_flows(position)
        return flows.coefficients(self.water.density, self.inflow, crossed=self._crossed)

    def slopes(self, position: Vector) -> Slopes:
        """Their derivatives by q_k, exact for the mesh: the affine form holds K and its slopes."""
        flows = self.unit_flows(position)
        stiffness, loads = self._affine.derivatives(position), self._loads.derivatives(position)
        return flows.slopes(self.water.density, stiffness, loads, crossed=self._crossed)
