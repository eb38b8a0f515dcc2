"""The loop with every combination of its slots, one and several degrees of freedom."""

import itertools
from dataclasses import dataclass, replace

import numpy as np
import pytest

from squat.coupling import (
    PREDICTORS,
    Aitken,
    Anderson,
    ConstantRelaxation,
    Coupling,
    Criterion,
    InterfaceQuasiNewton,
    Load,
    Monolithic,
    NoAcceleration,
    State,
    advance,
    corrected,
    march,
    standard,
)
from squat.coupling.amplification import amplification_matrix
from squat.coupling.loop import contraction
from squat.dynamics import INTEGRATORS, Motion

ACCELERATORS = {
    "none": NoAcceleration(name="none"),
    "relaxation": ConstantRelaxation(name="relaxation", factor=0.4),
    "aitken": Aitken(name="aitken", initial=0.4),
    "anderson": Anderson(name="anderson", depth=5, mixing=0.5, condition=1e8),
    "iqn_ils": InterfaceQuasiNewton(name="iqn_ils", initial=0.5, reuse=0, filter=1e-3),
    "iqn_ils_reuse": InterfaceQuasiNewton(name="iqn_ils", initial=0.5, reuse=2, filter=1e-3),
    "monolithic": Monolithic(name="monolithic"),
}
TIGHT = Criterion(name="absolute", tolerance=1e-14, iterations=2000, growth=1e8)


@dataclass(frozen=True)
class Chain:
    """Two coupled oscillators in a fluid of full added-mass matrix."""

    mass: np.ndarray
    fluid: np.ndarray
    stiffness: np.ndarray

    def load(self, trial, memory, dt):
        force = -self.fluid @ trial.acceleration - self.stiffness @ trial.position
        return Load(force, (memory or 0) + 1)


CHAIN = Chain(
    np.array([[2.0, 0.3], [0.3, 1.0]]),
    np.array([[1.2, 0.4], [0.4, 0.7]]),
    np.array([[30.0, -10.0], [-10.0, 20.0]]),
)


def start(problem):
    q, v = np.array([0.3, -0.2]), np.array([0.1, 0.5])
    a = -np.linalg.solve(problem.mass + problem.fluid, problem.stiffness @ q)
    return State((Motion(q, v, a),), memory=0)


def slots(
    scheme="corrected", accelerator="none", predictor="hold", integrator="newmark", criterion=TIGHT
):
    m_add = CHAIN.fluid * 1.2
    made = standard(CHAIN.mass) if scheme == "standard" else corrected(CHAIN.mass, m_add)
    return Coupling(
        lambda motion: made,
        INTEGRATORS[integrator],
        ACCELERATORS[accelerator],
        PREDICTORS[predictor],
        criterion,
    )


COMBINATIONS = list(
    itertools.product(["standard", "corrected"], ACCELERATORS, PREDICTORS, INTEGRATORS)
)


@pytest.mark.parametrize(("scheme", "accelerator", "predictor", "integrator"), COMBINATIONS)
def test_every_combination_reaches_the_implicit_solution(
    scheme, accelerator, predictor, integrator
):
    dt, count = 0.02, 20
    coupling = slots(scheme, accelerator, predictor, integrator)
    taken = list(march(CHAIN, coupling, start(CHAIN), dt, count))
    assert [step.status for step in taken] == ["converged"] * count
    past = start(CHAIN).past
    for step in taken:
        ties = INTEGRATORS[integrator].kinematics(past, dt)
        total = CHAIN.mass + CHAIN.fluid
        left = total * ties.s3 / dt**2 + CHAIN.stiffness
        exact = ties.at_position(np.linalg.solve(left, -total @ ties.a0))
        # Iteration stops within tolerance/(1 - |G|); rounding of q/dt^2 adds eps*40 steps.
        assert step.state.motion.position == pytest.approx(exact.position, abs=2e-12)
        past = (exact, *past[:2])


def test_contraction_of_the_vector_iteration_is_bounded_by_the_spectral_radius():
    step = advance(CHAIN, slots("standard"), start(CHAIN), 0.02)
    factor = amplification_matrix(
        CHAIN.mass, CHAIN.fluid, CHAIN.stiffness, 0.02, INTEGRATORS["newmark"], np.zeros((2, 2))
    )
    radius = max(abs(np.linalg.eigvals(factor)))
    ratios = step.residuals[5:15] / step.residuals[4:14]
    assert ratios[-1] == pytest.approx(radius, rel=0.02)


def test_memory_of_the_accepted_answer_is_carried_on_untouched():
    taken = list(march(CHAIN, slots(), start(CHAIN), 0.02, 5))
    assert taken[-1].state.memory == 5


def test_divergence_ends_the_march_and_keeps_residuals_and_last_state():
    heavy = replace(CHAIN, fluid=5 * CHAIN.mass)
    taken = list(march(heavy, slots("standard"), start(heavy), 0.02, 5))
    assert [step.status for step in taken] == ["diverged"]
    assert taken[0].residuals[-1] > 1e7 * taken[0].residuals[0]
    assert np.array_equal(taken[0].state.motion.position, start(heavy).motion.position)


@pytest.mark.parametrize("accelerator", ACCELERATORS)
def test_non_finite_force_is_divergence_not_a_crash(accelerator):
    class Broken(Chain):
        def load(self, trial, memory, dt):
            return Load(np.array([np.nan, np.nan]))

    broken = Broken(CHAIN.mass, CHAIN.fluid, CHAIN.stiffness)
    coupling = slots(accelerator=accelerator)
    state = advance(CHAIN, coupling, start(CHAIN), 0.02).state
    step = advance(broken, coupling, state, 0.02)
    assert step.status == "diverged"
    assert step.state is state
    if accelerator != "monolithic":
        assert step.iterations == 1


def test_iteration_limit_is_a_status_of_its_own():
    few = replace(TIGHT, iterations=3)
    step = advance(CHAIN, slots("standard", criterion=few), start(CHAIN), 0.02)
    assert (step.status, step.iterations) == ("iteration limit", 3)


def test_relative_criterion_scales_with_the_position():
    relative = replace(TIGHT, name="relative", tolerance=1e-6)
    small = advance(CHAIN, slots("standard", criterion=relative), start(CHAIN), 0.02)
    scaled = start(CHAIN)
    grown = State((Motion(*(1e6 * part for part in scaled.motion)),), 0)
    large = advance(CHAIN, slots("standard", criterion=relative), grown, 0.02)
    assert small.iterations == large.iterations
    assert large.residuals == pytest.approx(1e6 * small.residuals, rel=1e-6)


def test_aitken_solves_a_scalar_linear_problem_in_three_structure_solves():
    """The secant step is exact for one linear equation, converging or not."""
    one = Chain(np.array([[1.0]]), np.array([[7.0]]), np.array([[3.0]]))
    state = State((Motion(np.array([1.0]), np.array([0.0]), np.array([-3 / 8])),), 0)
    made = standard(one.mass)
    criterion = replace(TIGHT, tolerance=1e-12)
    coupling = Coupling(
        lambda motion: made,
        INTEGRATORS["newmark"],
        ACCELERATORS["aitken"],
        PREDICTORS["linear"],
        criterion,
    )
    state = advance(one, coupling, state, 0.01).state
    step = advance(one, coupling, state, 0.01)
    assert step.status == "converged"
    assert step.iterations == 3


@pytest.mark.parametrize(("predictor", "degree"), [("hold", 0), ("linear", 1), ("quadratic", 2)])
def test_predictors_are_exact_for_polynomials_of_their_degree(predictor, degree):
    dt = 0.1
    times = -dt * np.arange(3)
    past = tuple(Motion(*np.full((3, 1), t**degree)) for t in times)
    ties = INTEGRATORS["newmark"].kinematics(past, dt)
    assert PREDICTORS[predictor](past, ties).position == pytest.approx(
        dt**degree if degree else 1.0
    )


def test_quadratic_predictor_starts_on_the_parabola_of_the_initial_motion():
    start = Motion(np.array([1.0]), np.array([2.0]), np.array([6.0]))
    ties = INTEGRATORS["newmark"].kinematics((start,), 0.1)
    assert PREDICTORS["quadratic"]((start,), ties).position == pytest.approx(1.23, abs=1e-14)


def test_contraction_needs_three_residuals():
    assert np.isnan(contraction(np.array([[1.0], [0.5]])))
    assert contraction(np.array([[9.0], [1.0], [-0.5], [0.25]])) == pytest.approx(-0.5)
