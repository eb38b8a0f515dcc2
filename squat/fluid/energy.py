"""Ship and water as one system with a kinetic and a potential energy: a `dynamics.Lagrangian`.

    M = M_s + c,   U = U_h + m g z_G + (V^2/2) (rho A_sub - a),   Gam_ij = V (db_j/dq_i - db_i/dq_j)

Source: docs/theory/energy.md.
"""

from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np

from squat.dynamics import Motion, RigidBody
from squat.dynamics.hydrostatics import Hydrostatics
from squat.fluid.model import EnergyModel, check_current
from squat.fluid.variational import dynamic_force, gyroscopic
from squat.mesh import Submesh
from squat.quantities import Vector
from squat.water import Water


def still_water(submesh: Submesh, water: Water) -> Hydrostatics:
    """Hydrostatics of the hull that `submesh` moves, in its modes."""
    hull, level = submesh.rest[submesh.hull], submesh.motion.level
    ends = np.array([[hull[0, 0], level], [hull[-1, 0], level]])
    chain = np.vstack([ends[:1], hull, ends[1:]])
    return Hydrostatics(water, chain, submesh.motion.center, level, submesh.modes)


class Energies(NamedTuple):
    """Where the energy of ship and water is, and what the ends of the channel feed [J/m, W/m].

    ship: q'^T M_s q'/2; water: T_f = (V^2 a + 2 V b.q' + q'^T c q')/2; static: U_h + m g z_G, and
    a mooring's, from its value at rest; stream: U_B = rho V^2 A_sub/2 likewise; supply:
    V (V a + b.q'); power: its rate in a constant current, what enters through In and Out.
    """

    ship: float
    water: float
    static: float
    stream: float
    supply: float
    power: float

    @property
    def total(self) -> float:
        """Energy of ship and water; its rate is that of `supply`."""
        return self.ship + self.water + self.static + self.stream

    @property
    def conserved(self) -> float:
        """E = q'^T M q'/2 + U: constant in a constant current."""
        return self.total - self.supply


@dataclass(frozen=True, eq=False)
class ShipEnergy:
    """A ship in a current V: M(q), U(q), Gam(q) and the force that follows from them.

    U is zero at q = 0 and V = 0; in general U(0) = -V^2 a(0)/2.

    Parameters
    ----------
    body
        Mass matrix and weight.
    hydrostatics
        Of the same modes.
    model
        The water's energy coefficients: `PotentialFluid`, `Curves`, or another.
    current
        V [m/s].
    """

    body: RigidBody
    hydrostatics: Hydrostatics
    model: EnergyModel
    current: float

    def __post_init__(self) -> None:
        check_current(self.model.free_surface, self.current)

    def at_current(self, current: float) -> "ShipEnergy":
        """The same ship in another current; a, b, c do not depend on it."""
        return replace(self, current=current)

    @property
    def lengths(self) -> Vector:
        """What makes the coordinates comparable, shape (n,): 1, for pitch L/2 [m]."""
        half = self.hydrostatics.length / 2
        return np.array([half if mode == "pitch" else 1.0 for mode in self.body.modes])

    def mass(self, q: Vector) -> Vector:
        """M = M_s + c, shape (n, n)."""
        return self.body.mass_matrix(q) + self.model.coefficients(q).c

    def mass_gradient(self, q: Vector) -> Vector:
        """dM_ij/dq_k at [i, j, k], shape (n, n, n)."""
        return self.body.mass_gradient(q) + self.model.slopes(q).c

    def potential(self, q: Vector) -> float:
        """U [J/m]."""
        static, stream = self._potentials(q)
        return static + stream - self.current**2 / 2 * self.model.coefficients(q).a

    def gradient(self, q: Vector) -> Vector:
        """dU/dq, shape (n,) [N/m]."""
        return self.static_gradient(q) - self.current**2 / 2 * self.model.slopes(q).a

    def gyroscopic(self, q: Vector) -> Vector:
        """Gam, shape (n, n); zero for one mode."""
        return gyroscopic(self.model.slopes(q), self.current)

    def static_gradient(self, q: Vector) -> Vector:
        """d(U_h + U_B + m g z_G)/dq, shape (n,), a mooring included: what still water balances."""
        return self.body.gradient(q) - self._still(q)

    def water_force(self, motion: Motion, current_rate: float = 0.0) -> Vector:
        """Generalised force of the water, shape (n,) [N/m], for q, q', q'' and dV/dt [m/s2]."""
        q, velocity, acceleration = motion
        return self._still(q) + dynamic_force(
            self.model.coefficients(q),
            self.model.slopes(q),
            self.current,
            velocity,
            acceleration,
            current_rate,
        )

    def energies(self, motion: Motion) -> Energies:
        """Energy, term by term, for q, q' and q''; the power alone depends on the last."""
        (q, velocity, acceleration), V = motion, self.current
        (a, b, c), slopes = self.model.coefficients(q), self.model.slopes(q)
        crossed = float(b @ velocity)
        ship = float(velocity @ self.body.mass_matrix(q) @ velocity) / 2
        water = (V**2 * a + 2 * V * crossed + float(velocity @ c @ velocity)) / 2
        rate = V * slopes.a @ velocity + velocity @ slopes.b @ velocity + b @ acceleration
        potentials = self._potentials(q)
        return Energies(ship, water, *potentials, V * (V * a + crossed), V * float(rate))

    def _potentials(self, q: Vector) -> tuple[float, float]:
        """U_h + m g z_G (and the mooring's), and U_B, each from its value at rest."""
        water = self.hydrostatics
        static = water.potential(q) - water.rest[0] + self.body.potential(q)
        return static, self._head * (water.area(q) - water.rest[1])

    def _still(self, q: Vector) -> Vector:
        """-d(U_h + U_B)/dq, shape (n,)."""
        return -self.hydrostatics.gradient(q) - self._head * self.hydrostatics.area_gradient(q)

    @property
    def _head(self) -> float:
        """rho V^2/2 [Pa]."""
        return self.hydrostatics.water.density * self.current**2 / 2
