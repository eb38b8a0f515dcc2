"""The energy-momentum step of one degree of freedom in plain floats, for long runs.

For n = 1 the discrete gradient is g = [f(w1) - f(w0)]/(w1 - w0), whatever the metric.
"""

from math import inf, isfinite
from typing import NamedTuple

import numpy as np

from squat.dynamics.energy_momentum import LIMITS, ROUNDING, Limits, Outcome
from squat.dynamics.lagrangian import OneMode
from squat.quantities import Vector

_APART = 1e-3
"""Distance [m] from which on the difference quotient has no rounding to speak of."""


class Track(NamedTuple):
    """A run: w and P (steps + 1,), sweeps of each step (steps,), and how the last one ended."""

    position: Vector
    momentum: Vector
    sweeps: Vector
    outcome: Outcome


def advance_one(
    system: OneMode, w0: float, P0: float, dt: float, limits: Limits = LIMITS
) -> tuple[float, float, Outcome, list[float]]:
    """New w, new P, how the sweeps ended, and the change of w in each."""
    M0, U0, dM0, dU0 = system(w0)
    W0 = 1 / M0
    speed = W0 * P0
    dw = dt * (speed - dt / 2 * W0 * (dU0 + dM0 * speed**2 / 2))
    P1 = P0 - dt * (dU0 - dM0 * speed**2 / 2)
    changes: list[float] = []
    first = last = inf
    while len(changes) < limits.sweeps:
        M1, U1, _, _ = system(w0 + dw)
        W1 = 1 / M1
        square = (P1 * P1 + P0 * P0) / 4
        rise = square * (W1 - W0) + U1 - U0
        if abs(dw) > _APART:
            g = rise / dw
        else:
            M, _, dM, dU = system(w0 + dw / 2)
            g = dU - square * dM / M**2
            if abs(rise - g * dw) > ROUNDING * (abs(U1) + square * W1):
                g = rise / dw
        P1 = P0 - dt * g
        new = dt / 4 * (W0 + W1) * (P0 + P1)
        changes.append(new - dw)
        now, dw = abs(new - dw), new
        if len(changes) == 1:
            first = now
        if outcome := limits.outcome(now, last, first, abs(w0 + dw)):
            return w0 + dw, P1, outcome, changes
        last = now
    return w0 + dw, P1, "iteration limit", changes


def trajectory(
    system: OneMode, w: float, P: float, dt: float, steps: int, limits: Limits = LIMITS
) -> Track:
    """At most `steps` steps of `dt` [s] from w and P, ending with the first that fails."""
    positions, momenta, sweeps = [w], [P], []
    outcome: Outcome = "converged"
    for _ in range(steps):
        w, P, outcome, changes = advance_one(system, w, P, dt, limits)
        if outcome != "converged" or not isfinite(w):
            break
        positions.append(w)
        momenta.append(P)
        sweeps.append(len(changes))
    return Track(np.array(positions), np.array(momenta), np.array(sweeps, float), outcome)
