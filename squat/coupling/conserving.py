"""Structure and fluid stepped as one system that keeps its energy: no partitioned iteration."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np

from squat.coupling.criteria import Criterion
from squat.coupling.loop import State, Step, contraction
from squat.dynamics import Motion
from squat.dynamics.energy_momentum import ROUNDING, Limits, Outcome, Phase, advance
from squat.dynamics.lagrangian import Lagrangian, OneMode, acceleration
from squat.dynamics.one_mode import advance_one
from squat.quantities import Vector


class _End(NamedTuple):
    motion: Motion
    outcome: Outcome
    changes: Vector


@dataclass(frozen=True)
class Modes:
    """A system of n modes; `lengths` (n,) make them comparable: 1, for pitch L/2 [m].

    `rounding` is the share of its energy that the system does not know.
    """

    system: Lagrangian
    lengths: Vector
    rounding: float = ROUNDING

    def advance(self, motion: Motion, dt: float, limits: Limits) -> _End:
        """Motion at the end of a step, how its sweeps ended, their changes (k, n)."""
        q, velocity, _ = motion
        phase = Phase(q, self.system.mass(q) @ velocity)
        end = advance(self.system, phase, dt, self.lengths, limits, self.rounding)
        (q, P), outcome, changes = end
        velocity = np.asarray(np.linalg.solve(self.system.mass(q), P), float)
        return _End(Motion(q, velocity, acceleration(self.system, q, velocity)), outcome, changes)


@dataclass(frozen=True)
class SingleMode:
    """A system of one mode in plain floats."""

    system: OneMode

    def advance(self, motion: Motion, dt: float, limits: Limits) -> _End:
        """See `Modes.advance`."""
        w, velocity = float(motion.position[0]), float(motion.velocity[0])
        P = self.system(w)[0] * velocity
        w, P, outcome, changes = advance_one(self.system, w, P, dt, limits)
        M, _, dM, dU = self.system(w)
        velocity = P / M
        values = w, velocity, -(dU + dM * velocity**2 / 2) / M
        end = Motion(*(np.array([value]) for value in values))
        return _End(end, outcome, np.array(changes)[:, None])


@dataclass(frozen=True)
class Conserving:
    """`integrator=energy_momentum`: see squat/dynamics/energy_momentum.py.

    Parameters
    ----------
    whole
        Structure and fluid together.
    limits
        When the sweeps of a step end.
    memory
        What the problem remembers at the end of a step, from its motion, the memory before and dt.
    """

    whole: Modes | SingleMode
    limits: Limits
    memory: Callable[[Motion, Any, float], Any]

    @staticmethod
    def of(
        whole: Modes | SingleMode,
        criterion: Criterion,
        memory: Callable[[Motion, Any, float], Any] = lambda motion, memory, dt: memory,
    ) -> "Conserving":
        """Steps with the limits of `criterion`; not its tolerance: sweeps go to rounding."""
        return Conserving(whole, Limits(criterion.iterations, criterion.growth), memory)

    def advance(self, state: State, dt: float) -> Step:
        """One time step of `dt` [s]; every sweep counts as an iteration."""
        motion, outcome, changes = self.whole.advance(state.motion, dt, self.limits)
        end = state
        if outcome == "converged":
            end = state.followed_by(motion, self.memory(motion, state.memory, dt))
        residuals = np.linalg.norm(changes, axis=1)
        unknown = np.full_like(motion.position, np.nan)
        return Step(outcome, end, residuals, contraction(changes), unknown)
