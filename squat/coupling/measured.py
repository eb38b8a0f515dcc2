"""A problem of several modes in metres, for one tolerance, and with some of its modes held."""

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from squat.coupling.loop import Coupling, State, Step, advance
from squat.coupling.problem import Load, Problem
from squat.dynamics import Motion
from squat.quantities import Vector


@dataclass(frozen=True, eq=False)
class Measured:
    """`problem` in the coordinates x_i = l_i q_i: a `Problem`.

    Residuals, criterion and accelerators see metres only; with all l = 1 nothing changes, bit for
    bit.

    Parameters
    ----------
    lengths
        l, shape (n,): 1 for a translation, L/2 [m] for pitch, the motion of bow and stern.
    free
        Shape (n,). No net force reaches a mode that is not free: it keeps its velocity.
    """

    problem: Problem
    lengths: Vector
    free: NDArray[np.bool_]

    @cached_property
    def _same(self) -> bool:
        """Whether x is q, and all of it free."""
        return bool(np.all(self.lengths == 1.0) and np.all(self.free))

    @property
    def mass(self) -> Vector:
        """Structural mass matrix of x, shape (n, n)."""
        return self.matrix(self.problem.mass)

    def load(self, trial: Motion, memory: Any, dt: float) -> Load:
        """See `Problem.load`."""
        if self._same:
            return self.problem.load(trial, memory, dt)
        force, memory = self.problem.load(self.inward(trial), memory, dt)
        return Load(np.where(self.free, force / self.lengths, 0.0), memory)

    def matrix(self, masses: Vector) -> Vector:
        """Masses (n, n) of q for x; between free and held modes there is no exchange."""
        apart = self.free[:, None] != self.free
        return np.where(apart, 0.0, masses / np.outer(self.lengths, self.lengths))

    def inward(self, motion: Motion) -> Motion:
        """Motion of q for one of x."""
        if self._same:
            return motion
        return Motion(*(part / self.lengths for part in motion))

    def outward(self, motion: Motion) -> Motion:
        """Motion of x for one of q."""
        return Motion(*(part * self.lengths for part in motion))

    def advanced(self, coupling: Coupling, state: State, dt: float) -> Step:
        """One time step of `dt` [s] from a state of q to one of q."""
        if self._same:
            return advance(self, coupling, state, dt)
        step = advance(self, coupling, _turned(state, self.outward), dt)
        return replace(step, state=_turned(step.state, self.inward))


def _turned(state: State, turn: Callable[[Motion], Motion]) -> State:
    return replace(state, past=tuple(turn(motion) for motion in state.past))
