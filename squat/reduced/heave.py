"""Integrated pressure in heave alone: five functions of heave, in plain floats.

The flow is linear in the current V and the velocity v, so that

    F = F_0 + v F_1 + v^2 F_2 - dm/dt,   m = m_0 + v m_1 = rho int_Ship phi n_z ds   [kg/s]

with functions F_i and m_i of heave alone. All that a step must remember of the potential is m.
"""

from dataclasses import dataclass, field

import numpy as np
from numpy.polynomial import Chebyshev, chebyshev

from squat.fluid.model import Coefficients, Flow
from squat.quantities import Vector
from squat.reduced.fluid import ReducedFluid
from squat.reduced.hull import HullFluid
from squat.reduced.table import Quintics

_POINTS = 48
"""Chebyshev points in log(clearance): over five e-foldings the series reach rounding."""


@dataclass(frozen=True, eq=False)
class HeaveFluid:
    """A `FluidModel` of heave whose potentials are m (1,), from tables of what `fluid` answers."""

    fluid: HullFluid
    table: Quintics
    _last: dict[float, tuple[float, ...]] = field(default_factory=dict, init=False, repr=False)

    @staticmethod
    def of(fluid: ReducedFluid) -> "HeaveFluid":
        """Tables over the whole box of `fluid`'s model."""
        exact = HullFluid.of(fluid)
        low, high = np.log(exact.model.box.bounds)
        nodes = chebyshev.chebpts1(_POINTS)
        clearance = exact.model.submesh.limits.clearance
        heave = np.exp((low + high + (high - low) * nodes) / 2) - clearance
        rows = np.array([_functions(exact, w) for w in heave])
        fitted = np.linalg.solve(chebyshev.chebvander(nodes, _POINTS - 1), rows)
        series = [Chebyshev(column, domain=[low, high]) for column in fitted.T]
        return HeaveFluid(exact, Quintics(series, clearance))

    @property
    def current(self) -> float:
        """V [m/s]."""
        return self.fluid.current

    def flow(self, position: Vector, velocity: Vector) -> Flow:
        """m (1,) for heave and its velocity, (1,) each; PositionError out of the box."""
        *_, m0, m1 = self._at(position)
        return Flow(position, velocity, m0 + m1 * velocity)

    def unit_potentials(self, position: Vector) -> tuple[Vector, Vector]:
        """m (1,) of the flow of unit current, and (1, 1) of that of unit velocity."""
        current, unit = _momenta(self.fluid, position).reshape(2, 1)
        return current, unit[None]

    def force(self, flow: Flow, rate: Vector) -> Vector:
        """Force (1,) of p - p_atm [N/m], given dm/dt (1,)."""
        steady, first, second, _, _ = self._at(flow.position)
        velocity = float(flow.velocity[0])
        return steady + velocity * (first + velocity * second) - rate

    def coefficients(self, position: Vector) -> Coefficients:
        """Energy coefficients a, b, c at `position`."""
        return self.fluid.coefficients(position)

    def _at(self, position: Vector) -> tuple[float, ...]:
        """F_0, F_1, F_2, m_0, m_1, kept for the last heave: flow and force ask in turn."""
        w = float(position[0])
        found = self._last.get(w)
        if found is None:
            if not self.table.holds(w):
                self.fluid.model.submesh.check(position)  # names the reason
            found = self.table(w)
            self._last.clear()
            self._last[w] = found
        return found


def _functions(fluid: HullFluid, heave: float) -> list[float]:
    """F_0, F_1, F_2, m_0, m_1 at one heave [m]."""
    q = np.array([heave])
    steady, ahead, astern = (_steady(fluid, q, v) for v in (0.0, 1.0, -1.0))
    m0, m1 = _momenta(fluid, q)
    odd, even = (ahead - astern) / 2, (ahead + astern) / 2 - steady
    return [steady, odd, even, fluid.current * m0, m1]


def _steady(fluid: HullFluid, position: Vector, velocity: float) -> float:
    """Force at a velocity [m/s] while the potential at the nodes does not change."""
    flow = fluid.flow(position, np.array([velocity]))
    return float(fluid.force(flow, np.zeros_like(flow.potential))[0])


def _momenta(fluid: HullFluid, position: Vector) -> Vector:
    """m of the flows of unit current and unit velocity, shape (2,)."""
    impulses = fluid.impulses(position) @ fluid.units(position).T
    return np.asarray(fluid.water.density * impulses[0])
