"""Where the energy is: the paper's balance of the ship, and that of ship and water together."""

import numpy as np
from scipy.integrate import cumulative_trapezoid

from squat.dynamics import Motion
from squat.fluid.energy import ShipEnergy
from squat.quantities import Vector
from squat.transient.case import TransientCase
from squat.transient.history import Columns
from squat.transient.parts import Parts


def energies(
    case: TransientCase, parts: Parts, time: Vector, columns: Columns
) -> dict[str, Vector]:
    """The ship's own work balance, section 3.6 (Fig. 13): E_c + E_p + W = E_0, (time,) [J/m].

    E_c = q'^T M_s q'/2, E_p = m g (T + w) and a mooring's, W = -int q'.F dt over the free modes by
    the trapezoidal rule. Any history of F satisfies E_c + E_p + W = E_0 up to that rule's error: it
    does not show that the water kept its energy.
    """
    body, velocity = parts.problem.body, columns.velocity
    power = (velocity * columns.force)[:, parts.problem.free].sum(axis=1)
    rest = case.mass * case.water.gravity * case.hull.outline.draft
    return {
        "kinetic_energy": ((velocity @ body.matrix) * velocity).sum(axis=1) / 2,
        "potential_energy": np.array([rest + body.potential(q) for q in columns.position]),
        "fluid_work": -np.asarray(cumulative_trapezoid(power, time, initial=0)),
    }


def audit(ship: ShipEnergy, columns: Columns) -> dict[str, Vector | float]:
    """Energy of ship and water, term by term, and what the ends of the channel feed, (time,).

    d/dt (T_ship + T_f + U_h + m g z_G + U_B) = V d/dt (V a + b.q'), so that the work of the ends
    since t = 0 is V (V a + b.q') less its first value, without any quadrature; the residual is
    what the run has gained or lost for no reason (docs/theory/energy.md). With `initial_energy` it
    gives E = q'^T M q'/2 + U at any time.
    """
    motions = map(Motion._make, zip(*columns[:3], strict=True))
    terms = [ship.energies(motion) for motion in motions]
    _, water, static, stream, supply, power = np.array(terms).T
    kept = np.array([term.conserved for term in terms])
    return {
        "water_energy": water,
        "static_energy": static,
        "stream_energy": stream,
        "end_power": power,
        "end_work": supply - supply[0],
        "energy_residual": kept - kept[0],
        "initial_energy": float(kept[0]),
    }
