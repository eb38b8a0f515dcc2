"""Quasi-Newton accelerators: finite termination, reuse, filtering; the monolithic reference."""

from dataclasses import dataclass, replace

import numpy as np
import pytest

from squat.coupling import (
    PREDICTORS,
    Aitken,
    Anderson,
    Coupling,
    Criterion,
    InterfaceQuasiNewton,
    Load,
    Monolithic,
    NoAcceleration,
    State,
    march,
    standard,
)
from squat.coupling.quasi_newton import Secants, conditioned, independent
from squat.dynamics import INTEGRATORS, Motion

IQN = InterfaceQuasiNewton(name="iqn_ils", initial=0.5, reuse=0, filter=1e-6)
REUSE = replace(IQN, reuse=2)
ANDERSON = Anderson(name="anderson", depth=20, mixing=0.5, condition=1e12)
CRITERION = Criterion(name="absolute", tolerance=1e-11, iterations=500, growth=1e12)


@dataclass(frozen=True)
class Heavy:
    """n masses in a fluid several times as heavy, with a fluid force that may be nonlinear."""

    size: int
    ratio: float
    cubic: float = 0.0

    @property
    def mass(self):
        return np.eye(self.size)

    @property
    def fluid(self):
        random = np.random.default_rng(1).standard_normal((self.size, self.size))
        return self.ratio * (random @ random.T / self.size + 0.1 * np.eye(self.size))

    def load(self, trial, memory, dt):
        q = trial.position
        return Load(-self.fluid @ trial.acceleration - 9.0 * q - self.cubic * q**3)


def history(problem, accelerator, predictor="quadratic", steps=12, criterion=CRITERION):
    q = np.linspace(1.0, 0.5, problem.size)
    pull = problem.load(Motion(q, 0 * q, 0 * q), None, 0.0).force
    a = np.linalg.solve(problem.mass + problem.fluid, pull)
    scheme = standard(problem.mass)
    coupling = Coupling(
        lambda motion: scheme,
        INTEGRATORS["newmark"],
        accelerator,
        PREDICTORS[predictor],
        criterion,
    )
    return list(march(problem, coupling, State((Motion(q, 0 * q, a),)), 0.02, steps))


def positions(taken):
    return np.array([step.state.motion.position for step in taken])


@pytest.mark.parametrize("accelerator", [IQN, REUSE, ANDERSON], ids=lambda a: f"{a.name}")
@pytest.mark.parametrize("size", [1, 2, 3, 6])
def test_linear_problem_of_n_freedoms_ends_after_n_plus_two_solves(accelerator, size):
    """n independent changes make the model exact; one solve starts, one confirms."""
    taken = history(Heavy(size, 8.0), accelerator)
    assert {step.status for step in taken} == {"converged"}
    assert max(step.iterations for step in taken) <= size + 2


@pytest.mark.parametrize("size", [1, 2, 3])
def test_reuse_makes_later_steps_of_a_linear_problem_two_solves(size):
    """The Jacobian of earlier steps is exact: the first update solves, the second confirms."""
    taken = history(Heavy(size, 8.0), replace(REUSE, reuse=12))
    assert [step.iterations for step in taken[1:]] == [2] * 11
    assert min(step.iterations for step in history(Heavy(size, 8.0), IQN)) == size + 2


def test_reuse_needs_fewer_solves_of_a_nonlinear_problem():
    problem = Heavy(3, 8.0, cubic=40.0)
    with_reuse, without = (
        sum(step.iterations for step in history(problem, accelerator))
        for accelerator in (REUSE, IQN)
    )
    assert with_reuse < 0.8 * without


def test_columns_outlive_exactly_the_steps_that_reuse_allows():
    problem = Heavy(6, 8.0, cubic=40.0)
    for reuse in (0, 1, 3):
        learned = history(problem, replace(REUSE, reuse=reuse))[-1].state.learned
        if reuse == 0:
            assert learned is None
        else:
            assert isinstance(learned, Secants)
            assert 1 <= learned.steps.min() <= learned.steps.max() <= reuse


def test_a_state_is_all_that_a_run_goes_on_from():
    problem = Heavy(3, 8.0, cubic=40.0)
    whole = history(problem, REUSE)
    scheme = standard(problem.mass)
    slots = (INTEGRATORS["newmark"], REUSE, PREDICTORS["quadratic"], CRITERION)
    coupling = Coupling(lambda motion: scheme, *slots)
    rest = list(march(problem, coupling, whole[4].state, 0.02, 7))
    assert np.array_equal(positions(rest), positions(whole)[5:])
    assert [step.iterations for step in rest] == [step.iterations for step in whole[5:]]


def test_filter_keeps_the_newest_of_columns_that_span_the_same():
    a, b = np.array([1.0, 0.0, 0.0]), np.array([1.0, 1.0, 0.0])
    columns = np.array([a, 2 * a, 0 * a, b, a + 1e-9 * b, a - b])
    assert independent(columns, 1e-6) == [0, 3]
    assert independent(columns, 1e-12) == [0, 3]
    assert independent(np.array([a, a + 1e-3 * b]), 1e-6) == [0, 1]
    assert conditioned(np.array([a, b]), 1e3)
    assert not conditioned(np.array([a, a + 1e-9 * b]), 1e3)
    assert not conditioned(np.array([0 * a, b]), 1e3)


@pytest.mark.parametrize("accelerator", [IQN, REUSE, ANDERSON], ids=lambda a: f"{a.name}")
def test_freedoms_that_move_alike_do_not_upset_the_model(accelerator):
    """Identical masses give parallel columns in every iteration."""

    class Alike(Heavy):
        @property
        def fluid(self):
            return 8.0 * np.eye(self.size)

        def load(self, trial, memory, dt):
            return Load(-self.fluid @ trial.acceleration - 9.0 * trial.position.mean() ** 3)

    taken = history(Alike(4, 8.0), accelerator)
    assert {step.status for step in taken} == {"converged"}
    assert max(step.iterations for step in taken) <= 6


@pytest.mark.parametrize("cubic", [0.0, 40.0])
@pytest.mark.parametrize("ratio", [0.3, 8.0])
def test_monolithic_solution_is_what_every_accelerator_converges_to(cubic, ratio):
    problem = Heavy(3, ratio, cubic)
    reference = history(problem, Monolithic(name="monolithic"))
    assert {step.status for step in reference} == {"converged"}
    for accelerator in (IQN, REUSE, ANDERSON, Aitken(name="aitken", initial=0.05)):
        found = history(problem, accelerator)
        # 12 steps of errors below the tolerance, each carried on by a factor near one.
        assert positions(found) == pytest.approx(positions(reference), abs=12 * 12 * 1e-11)


def test_monolithic_solves_a_linear_step_with_few_evaluations():
    """n + 1 for the Jacobian and residual, one to confirm, one to end with."""
    for step in history(Heavy(3, 50.0), Monolithic(name="monolithic")):
        assert step.residuals[-1] < 1e-12


def test_divergence_is_still_a_result_where_there_is_no_solution():
    """q'' = 1 + q''^2 has none."""

    class Impossible(Heavy):
        def load(self, trial, memory, dt):
            return Load(1 + trial.acceleration**2)

    plain = NoAcceleration(name="none")
    few = replace(CRITERION, iterations=30)
    for accelerator in (plain, IQN, REUSE, ANDERSON, Monolithic(name="monolithic")):
        taken = history(Impossible(2, 8.0), accelerator, criterion=few)
        assert taken[-1].status in ("diverged", "iteration limit"), accelerator
