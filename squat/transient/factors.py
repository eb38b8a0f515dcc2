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
    """G of the step that ends at each recorded position, shape (time,)."""
    before = np.concatenate([heave[:1], heave[:-1]])
    values = [
        factor(case, parts, curves, float(w), float(v), added_mass(case, parts, curves, float(w0)))
        for w0, w, v in zip(before, heave, velocity, strict=True)
    ]
    return np.array(values)


def added_mass(case: TransientCase, parts: Parts, curves: Curves, w: float) -> float:
    """m_add [kg/m] of the step that starts at heave `w` [m]."""
    if case.coupling.scheme == "consistent":
        return case.coupling.beta * float(curves.values(w)[2])
    return parts.added_mass if case.coupling.scheme == "corrected" else 0.0


def factor(
    case: TransientCase, parts: Parts, curves: Curves, w: float, velocity: float, m_add: float
) -> float:
    """G at heave `w` [m] and velocity [m/s] with the correction `m_add` [kg/m]."""
    integrator, rate = INTEGRATORS[case.coupling.integrator], RATES[case.coupling.potential_rate]
    s1, s2, s3 = integrator.s1, rate.s2, integrator.s3
    V, dt = case.current, parts.dt
    c = curves.values(w)[2]
    _, db, dc = curves.first(w)
    dda, ddb, ddc = curves.second(w)
    water_plane = heave_stiffness(case.water, case.hull.outline.length)
    stiffness = water_plane - V**2 * dda / 2 - V * velocity * ddb - velocity**2 * ddc / 2
    change = m_add - case.coupling.beta * c
    change += (s1 - s2) / s3 * dt * (V * db + velocity * dc) - dt**2 / s3 * stiffness
    return float(change / (case.mass + m_add))
