"""The amplification factor of the coupled run, predicted from the water's energy coefficients.

    G = [m_add - beta c + ((s1 - s2)/s3) dt (V b' + w' c') - (dt^2/s3) k] / (m + m_add)
    k = rho g L - V^2 a''/2 - V w' b'' - w'^2 c''/2,    beta = s1 s2/s3

where pressure is integrated (docs/theory/coupled.md); a, b, c at the current w. The variational
force holds -c w'' - c' w'^2/2 of the trial itself (docs/theory/energy.md):

    G = [m_add - c - (s1/s3) dt c' w' - (dt^2/s3) k] / (m + m_add)
    k = rho g L - V^2 a''/2 + c' w'' + w'^2 c''/2

For n modes the eigenvalue of largest modulus, with the sign of its real part, of

    (M_s + m_add)^-1 [m_add - beta c + (dt/s3) D - (dt^2/s3) K]
    D_ij = s1 (V b_j,i + w'_k c_kj,i) - s2 (V b_i,j + w'_k c_ik,j)

s2 = s1 and w'_k c_ij,k less for the variational force. K is the stiffness in still water: what is
left out is of the order of dt^2 V^2. With s1 = s2 the first terms in V are Gam.
"""

import math
from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from squat.dynamics.hydrostatics import heave_stiffness
from squat.fluid.curves import Curves
from squat.fluid.energy import still_water
from squat.fluid.model import EnergyModel, Slopes
from squat.fluid.rates import RATES
from squat.quantities import Vector
from squat.transient.case import TransientCase
from squat.transient.history import Columns
from squat.transient.parts import Parts


class Heaving(NamedTuple):
    """Heave [m], its velocity and its acceleration at one instant."""

    heave: float
    velocity: float
    acceleration: float


def predicted_contraction(
    case: TransientCase, parts: Parts, model: EnergyModel, columns: Columns
) -> Vector:
    """G of the step that ends at each recorded position, shape (time,).

    NaN for the energy-momentum step, which does not iterate between structure and fluid.

    Parameters
    ----------
    model
        The water of the run's mesh, over heave alone as `Curves`.
    """
    if case.coupling.conserving:
        return np.full(len(columns.position), np.nan)
    if isinstance(model, Curves):
        return _of_heave(case, parts, model, columns)
    return np.array(list(_of_modes(case, parts, model, columns)))


def _of_modes(
    case: TransientCase, parts: Parts, model: EnergyModel, columns: Columns
) -> Iterator[float]:
    """Largest eigenvalue by modulus at each recorded position."""
    choice, free = case.coupling, np.ix_(parts.problem.free, parts.problem.free)
    beta = choice.beta(case.force)
    K = still_water(parts.fluid.mesh.submesh, case.water).stiffness
    m_add = parts.added_mass * (choice.scheme == "corrected")
    positions, velocities = columns[:2]
    before = [positions[0], *positions[:-1]]
    for last, q, velocity in zip(before, positions, velocities, strict=True):
        if choice.scheme == "consistent":
            m_add = beta * model.coefficients(last).c
        D = _damping(case, model.slopes(q), velocity)
        change = m_add - beta * model.coefficients(q).c
        change += (parts.dt * D - parts.dt**2 * K) / choice.ties.s3
        G = np.linalg.solve((parts.problem.body.matrix + m_add)[free], change[free])
        largest = max(np.linalg.eigvals(G).tolist(), key=abs, default=0.0)
        yield math.copysign(abs(largest), complex(largest).real)


def _damping(case: TransientCase, slopes: Slopes, velocity: Vector) -> Vector:
    """D (n, n): what the force changes by with the velocity of the trial, and with its rates."""
    s1, V = case.coupling.ties.s1, case.current
    ahead = V * slopes.b.T + np.einsum("kji,k->ij", slopes.c, velocity)
    behind = V * slopes.b + np.einsum("ikj,k->ij", slopes.c, velocity)
    if case.force == "variational":
        return np.asarray(s1 * (ahead - behind - slopes.c @ velocity))
    return np.asarray(s1 * ahead - RATES[case.coupling.potential_rate].s2 * behind)


def _of_heave(case: TransientCase, parts: Parts, curves: Curves, columns: Columns) -> Vector:
    parts_of = (column[:, 0].tolist() for column in columns[:3])
    motions = [Heaving(*values) for values in zip(*parts_of, strict=True)]
    before = [motions[0], *motions[:-1]]
    values = [
        factor(case, parts, curves, motion, added_mass(case, parts, curves, last.heave))
        for last, motion in zip(before, motions, strict=True)
    ]
    return np.array(values)


def added_mass(case: TransientCase, parts: Parts, curves: Curves, w: float) -> float:
    """m_add [kg/m] of the step that starts at heave `w` [m]."""
    if case.coupling.scheme == "consistent":
        return case.coupling.beta(case.force) * float(curves.values(w)[2])
    return float(parts.added_mass[0, 0]) if case.coupling.scheme == "corrected" else 0.0


def factor(
    case: TransientCase, parts: Parts, curves: Curves, motion: Heaving, m_add: float
) -> float:
    """G at `motion` with the correction `m_add` [kg/m]."""
    terms = _variational if case.force == "variational" else _integrated
    s3 = case.coupling.ties.s3
    velocity_share, stiffness = terms(case, curves, motion)
    stiffness += heave_stiffness(case.water, case.hull.outline.length)
    change = m_add - case.coupling.beta(case.force) * float(curves.values(motion.heave)[2])
    change += (velocity_share * parts.dt - parts.dt**2 * stiffness) / s3
    return float(change / (case.mass + m_add))


def _integrated(case: TransientCase, curves: Curves, motion: Heaving) -> tuple[float, float]:
    """Weights of dt/s3 and of -dt^2/s3, the latter without buoyancy, for integrated pressure."""
    s1, s2 = case.coupling.ties.s1, RATES[case.coupling.potential_rate].s2
    (w, v, _), V = motion, case.current
    _, db, dc = curves.first(w)
    dda, ddb, ddc = curves.second(w)
    return (s1 - s2) * (V * db + v * dc), -(V**2) * dda / 2 - V * v * ddb - v**2 * ddc / 2


def _variational(case: TransientCase, curves: Curves, motion: Heaving) -> tuple[float, float]:
    """The same for the variational force."""
    w, v, acceleration = motion
    dc, (dda, _, ddc) = curves.first(w)[2], curves.second(w)
    s1 = case.coupling.ties.s1
    return -s1 * dc * v, -(case.current**2) * dda / 2 + dc * acceleration + v**2 * ddc / 2
