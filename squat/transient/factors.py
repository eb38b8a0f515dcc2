"""The amplification factor of the coupled run, predicted from the water's energy coefficients.

    G = [m_add - beta c + ((s1 - s2)/s3) dt (V b' + w' c') - (dt^2/s3) k] / (m + m_add)
    k = rho g L - V^2 a''/2 - V w' b'' - w'^2 c''/2,    beta = s1 s2/s3

(docs/theory/coupled.md); a, b, c at the current w.
"""

import numpy as np

from squat.dynamics import INTEGRATORS
from squat.dynamics.hydrostatics import heave_stiffness
from squat.fluid.curves import Curves
from squat.fluid.rates import RATES
from squat.quantities import Vector
from squat.transient.case import TransientCase
from squat.transient.parts import Parts


def predicted_contraction(
    case: TransientCase, parts: Parts, curves: Curves, heave: Vector, velocity: Vector
) -> Vector:
    """G at each recorded position, shape (time,)."""
    values = [
        factor(case, parts, curves, float(w), float(v))
        for w, v in zip(heave, velocity, strict=True)
    ]
    return np.array(values)


def factor(case: TransientCase, parts: Parts, curves: Curves, w: float, velocity: float) -> float:
    """G at heave `w` [m] and velocity [m/s]."""
    integrator, rate = INTEGRATORS[case.coupling.integrator], RATES[case.coupling.potential_rate]
    s1, s2, s3 = integrator.s1, rate.s2, integrator.s3
    V, dt = case.current, parts.dt
    m_add = parts.added_mass if case.coupling.scheme == "corrected" else 0.0
    c = curves.values(w)[2]
    _, db, dc = curves.first(w)
    dda, ddb, ddc = curves.second(w)
    water_plane = heave_stiffness(case.water, case.hull.outline.length)
    stiffness = water_plane - V**2 * dda / 2 - V * velocity * ddb - velocity**2 * ddc / 2
    change = m_add - s1 * s2 / s3 * c
    change += (s1 - s2) / s3 * dt * (V * db + velocity * dc) - dt**2 / s3 * stiffness
    return float(change / (case.mass + m_add))
