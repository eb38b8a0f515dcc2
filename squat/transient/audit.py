"""The ship's own work balance, section 3.6 (Fig. 13): E_c + E_p + W = E_0."""

import numpy as np
from scipy.integrate import cumulative_trapezoid

from squat.quantities import Vector
from squat.transient.case import TransientCase


def energies(
    case: TransientCase, time: Vector, heave: Vector, velocity: Vector, force: Vector
) -> dict[str, Vector]:
    """Kinetic and potential energy of the ship and the work it does on the water, (time,) [J/m].

    E_c = m w'^2/2, E_p = m g (T + w), W = -int w' F dt by the trapezoidal rule. Any history of F
    satisfies E_c + E_p + W = E_0 up to that rule's error: it does not show that the water kept its
    energy.
    """
    mass, draft = case.mass, case.hull.outline.draft
    return {
        "kinetic_energy": mass * velocity**2 / 2,
        "potential_energy": mass * case.water.gravity * (draft + heave),
        "fluid_work": -np.asarray(cumulative_trapezoid(velocity * force, time, initial=0)),
    }
