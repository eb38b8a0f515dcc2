"""The one coupling loop: Algorithm 1, and Algorithm 2 with another problem in it."""

import math
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, field
from typing import Any, Literal, NamedTuple

import numpy as np

from squat.coupling.accelerators import Accelerator, Updates
from squat.coupling.criteria import Criterion
from squat.coupling.monolithic import Monolithic, together
from squat.coupling.predictors import LEVELS, Predictor
from squat.coupling.problem import Load, Problem
from squat.coupling.quasi_newton import Secants
from squat.coupling.schemes import Scheme
from squat.dynamics import Integrator, Kinematics, Motion
from squat.quantities import Vector

Status = Literal["converged", "diverged", "iteration limit"]


@dataclass(frozen=True)
class Coupling:
    """The loop's slots; each is independent of the others.

    `scheme` maps the newest accepted motion to the structure solve of the next step, so that an
    added mass may follow the structure.
    """

    scheme: Callable[[Motion], Scheme]
    integrator: Integrator
    accelerator: Accelerator
    predictor: Predictor
    criterion: Criterion


@dataclass(frozen=True)
class State:
    """Where a run stands: accepted motions, newest first, and what was kept of earlier steps.

    `memory` is the problem's own; `learned` is what an accelerator reuses.
    """

    past: tuple[Motion, ...]
    memory: Any = None
    learned: Secants | None = None

    @property
    def motion(self) -> Motion:
        """The newest accepted motion."""
        return self.past[0]

    def followed_by(self, motion: Motion, memory: Any, learned: Secants | None = None) -> "State":
        """State after one more accepted step."""
        return State((motion, *self.past[: LEVELS - 1]), memory, learned)


@dataclass(frozen=True)
class Step:
    """One time step: its end, how the iteration went, and the answer accepted last.

    `force` is that answer; NaN where structure and fluid were stepped as one system.
    `residuals` holds |q^{k+1} - q^k| [m] of every iteration; `contraction` is the signed
    factor by which the residual vector changes from one iteration to the next.
    """

    status: Status
    state: State
    residuals: Vector
    contraction: float
    force: Vector = field(repr=False)

    @property
    def iterations(self) -> int:
        """Number of structure solves."""
        return len(self.residuals)


class _Iteration(NamedTuple):
    """How one step's iteration went: its end, the load accepted last, the residual vectors."""

    status: Status
    motion: Motion
    load: Load
    residuals: list[Vector]
    learned: Secants | None = None


def advance(problem: Problem, coupling: Coupling, state: State, dt: float) -> Step:
    """One time step of size `dt` [s], until it converges, diverges or hits the iteration limit."""
    kinematics = coupling.integrator.kinematics(state.past, dt)
    guess = coupling.predictor(state.past, kinematics)
    accelerator = coupling.accelerator
    if isinstance(accelerator, Monolithic):
        done = _solve(problem, coupling.criterion, kinematics, guess, state.memory)
    else:
        scheme, updates = coupling.scheme(state.motion), accelerator.start(state.learned)
        done = _iterate(problem, coupling.criterion, kinematics, guess, state, scheme, updates)
    end = state
    if done.status == "converged":
        end = state.followed_by(done.motion, done.load.memory, done.learned)
    norms = _sizes(np.array(done.residuals))
    return Step(done.status, end, norms, contraction(done.residuals), done.load.force)


def _iterate(
    problem: Problem,
    criterion: Criterion,
    kinematics: Kinematics,
    trial: Motion,
    state: State,
    scheme: Scheme,
    updates: Updates,
) -> _Iteration:
    """Structure and fluid in turn, from `trial`."""
    residuals: list[Vector] = []
    first = 0.0
    status: Status = "iteration limit"
    while len(residuals) < criterion.iterations:
        load = problem.load(trial, state.memory, kinematics.dt)
        answer = scheme.solve(load.force, trial, kinematics)
        residuals.append(answer.position - trial.position)
        size = _size(residuals[-1])
        first = first or size
        if criterion.lost(size, first):
            status = "diverged"
            break
        trial = updates.next(trial, answer, kinematics)
        if criterion.met(size, answer.position):
            status = "converged"
            break
    learned = updates.learned() if status == "converged" else state.learned
    return _Iteration(status, answer, load, residuals, learned)


def _solve(
    problem: Problem, criterion: Criterion, kinematics: Kinematics, guess: Motion, memory: Any
) -> _Iteration:
    """Structure and fluid together, from `guess`."""
    end, load, residuals = together(problem, kinematics, guess, memory)
    met = criterion.met(float(np.linalg.norm(residuals[-1])), end.position)
    return _Iteration("converged" if met else "diverged", end, load, residuals)


def _size(residual: Vector) -> float:
    return math.sqrt(residual.dot(residual))


def _sizes(residuals: Vector) -> Vector:
    """Norms of the vectors (k, n); inf where a square is too large for a number."""
    return np.asarray(np.sqrt(np.einsum("ki,ki->k", residuals, residuals)))


def contraction(residuals: Iterable[Vector]) -> float:
    """Measured contraction factor of an iteration, NaN with fewer than three residuals.

    Parameters
    ----------
    residuals
        Residual vectors r^k, shape (n,) each.

    Notes
    -----
    The least-squares g of r^{k+1} = g r^k over the iterates that the predictor no longer
    touches: it may start from a motion that does not satisfy the integrator (`hold` does),
    so ratios count from the third iterate on. Residuals that have grown beyond the first of
    these are left out: where the iteration diverges they are no longer small.
    """
    vectors = np.array(list(residuals))
    if len(vectors) < 3:
        return math.nan
    sizes = _sizes(vectors)
    finite = np.isfinite(sizes)
    vectors, sizes = vectors[finite][1:], sizes[finite][1:]
    if len(sizes) < 2 or not sizes[0] > 0:
        return math.nan
    vectors, sizes = vectors / sizes[0], sizes / sizes[0]
    small = sizes[:-1] <= 1
    products = np.einsum("ki,ki", vectors[:-1][small], vectors[1:][small])
    return float(products / np.sum(sizes[:-1][small] ** 2))


def march(
    problem: Problem, coupling: Coupling, state: State, dt: float, steps: int
) -> Iterator[Step]:
    """At most `steps` steps of size `dt` [s], ending with the first that does not converge."""
    return repeated(lambda state: advance(problem, coupling, state, dt), state, steps)


def repeated(advance: Callable[[State], Step], state: State, steps: int) -> Iterator[Step]:
    """At most `steps` steps by `advance`, ending with the first that does not converge."""
    for _ in range(steps):
        step = advance(state)
        yield step
        if step.status != "converged":
            return
        state = step.state
