"""The reduced model as a flow solver: potentials where they are asked for, pressure on the hull."""

from dataclasses import dataclass, field, replace

import numpy as np

from squat.fluid.model import Coefficients, Flow, FreeSurface, Slopes, check_current
from squat.fluid.pressure import HullPressure
from squat.mesh import Mesh
from squat.quantities import Vector
from squat.reduced.model import ReducedModel
from squat.water import Water


@dataclass(eq=False)
class ReducedFluid:
    """A `FluidModel` and `EnergyModel` from a reduced basis, in a current of `current` [m/s].

    Parameters
    ----------
    model
        The reduced energies.
    mesh
        The nodes at which potentials are wanted: the patch beside the hull, which is all that a
        coupled run needs, or the whole mesh for fields.
    basis
        Basis functions of each system at these nodes, shape (N, nodes) each.
    """

    model: ReducedModel
    mesh: Mesh
    basis: tuple[Vector, ...]
    water: Water
    current: float
    pressure: HullPressure = field(init=False)

    def __post_init__(self) -> None:
        check_current(self.free_surface, self.current)
        self.mesh = replace(self.mesh, submesh=self.model.submesh)
        self.pressure = HullPressure(self.mesh, self.water)

    @property
    def free_surface(self) -> FreeSurface:
        """What the water's surface is taken for."""
        return self.model.free_surface

    def flow(self, position: Vector, velocity: Vector) -> Flow:
        """Potential for hull position and velocity, (n,) each; PositionError out of the box."""
        speeds = np.concatenate([[self.current], velocity])
        potential = np.zeros(len(self.mesh.points))
        parts = zip(self.model.systems, self.model.solve(position).u, self.basis, strict=True)
        for system, u, basis in parts:
            potential += (speeds[system.flows] @ u) @ basis
        return Flow(position, velocity, potential)

    def force(self, flow: Flow, rate: Vector) -> Vector:
        """Generalised force (n,) of p - p_atm, given d phi/dt at the moving nodes."""
        return self.pressure.force(flow, rate, self.current)

    def unit_potentials(self, position: Vector) -> tuple[Vector, Vector]:
        """phi_0 (nodes,) of unit current and phi_j (n, nodes) of unit velocities."""
        found = np.zeros((1 + len(self.model.modes), len(self.mesh.points)))
        parts = zip(self.model.systems, self.model.solve(position).u, self.basis, strict=True)
        for system, u, basis in parts:
            found[system.flows] = u @ basis
        return found[0], found[1:]

    def coefficients(self, position: Vector) -> Coefficients:
        """Energy coefficients a, b, c at `position`."""
        return self.model.coefficients(position)

    def slopes(self, position: Vector) -> Slopes:
        """Their derivatives at `position`."""
        return self.model.slopes(position)
