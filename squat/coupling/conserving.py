"""Structure and fluid stepped as one system that keeps its energy: no partitioned iteration."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

from squat.coupling.criteria import Criterion
from squat.coupling.loop import State, Step, contraction
from squat.dynamics import Motion
from squat.dynamics.energy_momentum import Advance, Limits, Phase, advance
from squat.dynamics.lagrangian import Lagrangian, OneMode, acceleration
from squat.dynamics.one_mode import advance_one
from squat.quantities import Vector


@dataclass(frozen=True)
class Conserving:
    """`integrator=energy_momentum`: see squat/dynamics/energy_momentum.py.

    Parameters
    ----------
    system
        Masses and potential of structure and fluid together.
    lengths
        Of the coordinates, shape (n,): 1 for a translation, L/2 [m] for pitch.
    limits
        When the sweeps of a step end.
    memory
        What the problem remembers at the end of a step, from its motion, the memory before and dt.
    one
        The same system in plain floats, where it has one mode and can.
    """

    system: Lagrangian
    lengths: Vector
    limits: Limits
    memory: Callable[[Motion, Any, float], Any]
    one: OneMode | None = None

    def advance(self, state: State, dt: float) -> Step:
        """One time step of `dt` [s]; every sweep counts as an iteration."""
        done = self._advance(state.motion, dt)
        residuals = np.linalg.norm(done.changes, axis=1)
        motion, end = self._motion(done.phase), state
        if done.outcome == "converged":
            end = state.followed_by(motion, self.memory(motion, state.memory, dt))
        unknown = np.full_like(motion.position, np.nan)
        return Step(done.outcome, end, residuals, contraction(done.changes), unknown)

    def _advance(self, motion: Motion, dt: float) -> Advance:
        q, velocity, _ = motion
        if self.one is None:
            phase = Phase(q, self.system.mass(q) @ velocity)
            return advance(self.system, phase, dt, self.lengths, self.limits)
        w = float(q[0])
        P = self.one(w)[0] * float(velocity[0])
        w, P, outcome, changes = advance_one(self.one, w, P, dt, self.limits)
        return Advance(Phase(np.array([w]), np.array([P])), outcome, np.array(changes)[:, None])

    def _motion(self, phase: Phase) -> Motion:
        q, P = phase
        if self.one is None:
            velocity = np.asarray(np.linalg.solve(self.system.mass(q), P), float)
            return Motion(q, velocity, acceleration(self.system, q, velocity))
        M, _, dM, dU = self.one(float(q[0]))
        velocity = P / M
        return Motion(q, velocity, -(dU + dM * velocity**2 / 2) / M)


def limits(criterion: Criterion) -> Limits:
    """Limits of the sweeps from those of the iteration; its tolerance is not used."""
    return Limits(criterion.iterations, criterion.growth)
