"""A time step that keeps the energy E = P^T W P/2 + U, W = M^-1, for any step size.

With bars for means of the old and the new level,

    f(q) = (P1^T W(q) P1 + P0^T W(q) P0)/4 + U(q)
    g    = f'(qb) + [f(q1) - f(q0) - f'(qb).dq] D dq / (dq^T D dq)
    dq   = dt Wb Pb,     dP = dt (-g + Gam(qb) Wb Pb)

so that E1 - E0 = dP.Wb Pb + f(q1) - f(q0) = 0, Gam being antisymmetric. Second order, symmetric in
time. g is Gonzalez' midpoint discrete gradient (J. Nonlinear Sci. 6 (1996) 449-467) in the metric
D; derived in docs/theory/energy.md. The equations are solved by fixed-point sweeps to rounding.
"""

from dataclasses import dataclass
from math import inf
from typing import Literal, NamedTuple

import numpy as np

from squat.dynamics.lagrangian import Lagrangian
from squat.quantities import Vector

Outcome = Literal["converged", "diverged", "iteration limit"]
EPS = float(np.finfo(float).eps)
ROUNDING = 32 * EPS
"""Share of an energy below which a difference of two means nothing, where that is exact to EPS."""
_APART, _LOOKS = 1e-9, 8
"""Distance [m] of positions whose energies differ by rounding and a straight line; how many."""


class Phase(NamedTuple):
    """Position q and momentum P = M q', shape (n,) each."""

    position: Vector
    momentum: Vector


class Advance(NamedTuple):
    """One step: where it leads, how its sweeps ended, and q^{k+1} - q^k of each, shape (k, n)."""

    phase: Phase
    outcome: Outcome
    changes: Vector


@dataclass(frozen=True)
class Limits:
    """When the sweeps of a step end.

    Parameters
    ----------
    sweeps
        Largest number.
    growth
        The step has diverged where a change is not finite or this many times the first.
    small, falling
        Changes below the share `small` of the position are rounding once they no longer fall by
        the factor `falling`.
    """

    sweeps: int = 200
    growth: float = 1e8
    small: float = 1e-9
    falling: float = 0.9

    def outcome(self, now: float, last: float, first: float, size: float) -> Outcome | None:
        """How a change `now` after `last` ends the sweeps at positions of `size`; None: not yet."""
        if now <= EPS * size or (self.falling * last <= now <= self.small * size):
            return "converged"
        return None if now <= self.growth * max(first, EPS * size) else "diverged"


LIMITS = Limits()


def rounding_of(system: Lagrangian, q: Vector, lengths: Vector) -> float:
    """Share of its energy that `system` does not know, near q: a flow's solves round more than EPS.

    Twice what second differences of M and U over a nanometre leave, and `ROUNDING` at least.
    """
    places = q + np.arange(_LOOKS)[:, None] * _APART / lengths
    masses = np.array([system.mass(place) / np.outer(lengths, lengths) for place in places])
    energies = np.array([system.potential(place) for place in places])
    return max(ROUNDING, 2 * _left(masses), 2 * _left(energies))


def _left(values: Vector) -> float:
    """Largest second difference along the first axis, over the largest value."""
    largest = np.abs(values).max()
    return float(np.abs(np.diff(values, 2, axis=0)).max() / largest) if largest > 0 else 0.0


def advance(
    system: Lagrangian,
    phase: Phase,
    dt: float,
    lengths: Vector,
    limits: Limits = LIMITS,
    rounding: float = ROUNDING,
) -> Advance:
    """One step of `dt` [s].

    Parameters
    ----------
    lengths
        Square roots of D's diagonal, shape (n,): 1 for a translation, L/2 [m] for pitch.
    rounding
        Share of an energy below which a difference of two means nothing, see `rounding_of`.
    """
    (q0, P0), D = phase, lengths**2
    W0, U0 = np.linalg.inv(system.mass(q0)), system.potential(q0)
    dq, dP = dt * W0 @ P0, np.zeros_like(P0)
    changes: list[Vector] = []
    first = last = inf
    outcome: Outcome | None = None
    while outcome is None and len(changes) < limits.sweeps:
        q1, P1 = q0 + dq, P0 + dP
        W1 = np.linalg.inv(system.mass(q1))
        g, U1 = _gradient(system, q0 + dq / 2, (P0, P1)), system.potential(q1)
        kinetic = (P1 @ (W1 - W0) @ P1 + P0 @ (W1 - W0) @ P0) / 4
        lacking = kinetic + U1 - U0 - g @ dq
        if abs(lacking) > rounding * (abs(U1) + P0 @ W0 @ P0):
            g = g + lacking / (dq @ (D * dq)) * D * dq
        dP = system.gyroscopic(q0 + dq / 2) @ dq - dt * g
        changes.append(dt / 2 * (W0 + W1) @ (P0 + dP / 2) - dq)
        dq = dq + changes[-1]
        now = float(np.linalg.norm(lengths * changes[-1]))
        first = now if len(changes) == 1 else first
        outcome = limits.outcome(now, last, first, float(np.linalg.norm(lengths * (q0 + dq))))
        last = now
    return Advance(Phase(q0 + dq, P0 + dP), outcome or "iteration limit", np.array(changes))


def _gradient(system: Lagrangian, q: Vector, momenta: tuple[Vector, Vector]) -> Vector:
    """f'(q): P^T dW/dq_i P = -v^T dM/dq_i v with v = W P."""
    mass, slope = system.mass(q), system.mass_gradient(q)
    turned = (np.linalg.solve(mass, P) for P in momenta)
    kinetic = sum(np.tensordot(v @ slope, v, (0, 0)) for v in turned)
    return np.asarray(system.gradient(q) - kinetic / 4)
