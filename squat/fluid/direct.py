"""The water's energy coefficients by direct solves, on P1 or P2 meshes: for reference values.

`PotentialFluid` remembers solutions and factors from step to step; this one starts afresh at every
position, and stands meshes squeezed to a fiftieth of their height.
"""

from dataclasses import dataclass, field

import numpy as np

from squat.fem import Factorised
from squat.fluid.added_mass import DIRICHLET
from squat.fluid.elements import Elements
from squat.fluid.model import Coefficients, FreeSurface, Slopes
from squat.fluid.variational import UnitFlows
from squat.quantities import Vector
from squat.water import Water


@dataclass(eq=False)
class DirectEnergies(Elements):
    """An `EnergyModel` on a mesh of either order.

    Parameters
    ----------
    mesh
        With the modes of the motion.
    free_surface
        `rigid_lid`, Eq. (19); `zero_pressure`, Eq. (23), for the hull's motion, the current's flow
        keeping the lid: `blend` by another name.
    """

    water: Water
    free_surface: FreeSurface
    _last: UnitFlows | None = field(default=None, init=False, repr=False)

    @property
    def _lid(self) -> bool:
        return self.free_surface == "rigid_lid"

    def coefficients(self, position: Vector) -> Coefficients:
        """See `EnergyModel.coefficients`."""
        flows = self._flows(position)
        return flows.coefficients(self.water.density, self.inflow, crossed=self._lid)

    def slopes(self, position: Vector) -> Slopes:
        """See `EnergyModel.slopes`; exact for the mesh."""
        stiffness, loads = self._affine.derivatives(position), self._loads.derivatives(position)
        flows = self._flows(position)
        return flows.slopes(self.water.density, stiffness, loads, crossed=self._lid)

    def _flows(self, position: Vector) -> UnitFlows:
        last = self._last
        if last is None or not np.array_equal(last.position, position):
            theta, loads = self._affine.theta(position), self._loads.at(position)
            lid = Factorised.of(
                self._affine.matrix(theta), self.space.dofs(*DIRICHLET["rigid_lid"])
            )
            current, *unit = lid.solve(np.vstack([self.inflow, loads])).values
            if not self._lid:
                held = self.space.dofs(*DIRICHLET["zero_pressure"])
                unit = list(Factorised.of(self._affine.matrix(theta), held).solve(loads).values)
            last = UnitFlows(np.array(position), theta, loads, current, np.array(unit))
            self._last = last
        return last
