"""The step that keeps energy: to rounding, of second order, symmetric, honest where it fails."""

from types import SimpleNamespace

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from squat.dynamics.energy_momentum import (
    LIMITS,
    ROUNDING,
    Limits,
    Phase,
    advance,
    rounding_of,
)
from squat.dynamics.lagrangian import acceleration, energy
from squat.dynamics.one_mode import advance_one, trajectory

LENGTHS = np.array([1.0, 1.0, 2.0])
START = np.array([0.4, -0.3, 0.2]), np.array([0.5, 0.1, -0.6])


class Spinning:
    """Three modes with a mass, a potential and a gyroscopic force that all depend on q."""

    stiff = np.array([2.0, 3.0, 5.0])

    def mass(self, q):
        bend = np.array([np.cos(q[1]), np.sin(q[2]), q[0] ** 2])
        return np.diag([4.0, 5.0, 9.0]) + np.outer(bend, bend)

    def mass_gradient(self, q):
        bend = np.array([np.cos(q[1]), np.sin(q[2]), q[0] ** 2])
        rates = np.array([[0, -np.sin(q[1]), 0], [0, 0, np.cos(q[2])], [2 * q[0], 0, 0]])
        half = np.einsum("i,jk->ijk", bend, rates)
        return half + half.swapaxes(0, 1)

    def potential(self, q):
        return float(self.stiff @ q**2 / 2 + np.prod(np.cos(q)) + q[0] * q[1] ** 3)

    def gradient(self, q):
        c, s = np.cos(q), np.sin(q)
        turned = [-s[0] * c[1] * c[2], -c[0] * s[1] * c[2], -c[0] * c[1] * s[2]]
        return self.stiff * q + turned + np.array([q[1] ** 3, 3 * q[0] * q[1] ** 2, 0.0])

    def gyroscopic(self, q):
        x, y, z = 3 * np.cos(q)
        return np.array([[0, -z, y], [z, 0, -x], [-y, x, 0.0]])


class Pendulum:
    """One mode in floats, its mass changing with w."""

    def __call__(self, w):
        c, s = float(np.cos(w)), float(np.sin(w))
        return 2 + c, -3 * c, -s, 3 * s


class AsArrays:
    """The same as a Lagrangian of one mode."""

    def __init__(self, one):
        self.one = one

    def mass(self, q):
        return np.array([[self.one(q[0])[0]]])

    def mass_gradient(self, q):
        return np.array([[[self.one(q[0])[2]]]])

    def potential(self, q):
        return self.one(q[0])[1]

    def gradient(self, q):
        return np.array([self.one(q[0])[3]])

    def gyroscopic(self, q):
        return np.zeros((1, 1))


class Blurred(Pendulum):
    """The pendulum as a flow would answer: M and U with noise, their derivatives without."""

    noise = 1e-10

    def __call__(self, w):
        M, U, dM, dU = super().__call__(w)
        blur = self.noise * float(np.sin(1e13 * w))
        return M * (1 + blur), U * (1 - blur), dM, dU


def run(system, dt, steps, position=START[0], velocity=START[1]):
    lengths = LENGTHS[: len(position)]
    phases = [Phase(position, system.mass(position) @ velocity)]
    for _ in range(steps):
        step = advance(system, phases[-1], dt, lengths)
        assert step.outcome == "converged"
        phases.append(step.phase)
    return phases


def level(system, phase):
    return energy(system, phase.position, np.linalg.solve(system.mass(phase.position), phase[1]))


def test_gradients_of_the_made_up_system_are_its_derivatives():
    system, (q, _), h = Spinning(), START, 1e-5
    for k, e in enumerate(h * np.eye(3)):
        slope = (system.potential(q + e) - system.potential(q - e)) / (2 * h)
        assert system.gradient(q)[k] == pytest.approx(slope, rel=1e-8)
        rate = (system.mass(q + e) - system.mass(q - e)) / (2 * h)
        assert system.mass_gradient(q)[:, :, k] == pytest.approx(rate, abs=1e-8)


@pytest.mark.parametrize("dt", [0.02, 0.1, 0.2])
def test_energy_stays_to_rounding_whatever_the_step(dt):
    system = Spinning()
    levels = np.array([level(system, phase) for phase in run(system, dt, 400)])
    assert np.abs(levels - levels[0]).max() < 1e-13 * np.abs(levels[0]) * np.sqrt(400)


def test_gyroscopic_force_bends_the_path_and_does_no_work():
    """Without it the path is another: conservation alone would not see it missing."""

    class Straight(Spinning):
        def gyroscopic(self, q):
            return np.zeros((3, 3))

    ends = [run(kind(), 0.1, 30)[-1].position for kind in (Spinning, Straight)]
    assert np.linalg.norm(ends[0] - ends[1]) > 0.1


def test_refinement_converges_to_the_equations_of_motion_with_order_two():
    system = Spinning()

    def rates(t, state):
        return np.concatenate([state[3:], acceleration(system, state[:3], state[3:])])

    exact = solve_ivp(rates, (0, 2), np.concatenate(START), rtol=1e-11, atol=1e-12).y[:3, -1]
    errors = [np.linalg.norm(run(system, 2 / n, n)[-1].position - exact) for n in (40, 80, 160)]
    orders = np.log2(np.array(errors[:-1]) / errors[1:])
    assert orders == pytest.approx(2, abs=0.02)


def test_step_back_undoes_the_step():
    system = Spinning()
    there = run(system, 0.2, 50)[-1]
    back = there
    for _ in range(50):
        back = advance(system, back, -0.2, LENGTHS).phase
    assert back.position == pytest.approx(START[0], abs=1e-12)


def test_floats_and_arrays_take_the_same_step():
    one, dt = Pendulum(), 0.1
    phases = run(AsArrays(one), dt, 100, np.array([0.8]), np.array([0.0]))
    track = trajectory(one, 0.8, 0.0, dt, 100)
    assert track.outcome == "converged"
    assert track.position == pytest.approx(np.array([p.position[0] for p in phases]), abs=1e-12)
    assert track.momentum == pytest.approx(np.array([p.momentum[0] for p in phases]), abs=1e-12)


def test_rest_at_an_equilibrium_stays():
    w, P, outcome, _ = advance_one(Pendulum(), 0.0, 0.0, 0.1)
    assert (w, P, outcome) == (0.0, 0.0, "converged")
    phase = Phase(np.zeros(1), np.zeros(1))
    assert advance(AsArrays(Pendulum()), phase, 0.1, np.ones(1)).phase == phase


def test_rounding_of_a_system_is_measured():
    assert rounding_of(Spinning(), START[0], LENGTHS) == pytest.approx(ROUNDING, rel=0.5)
    found = rounding_of(AsArrays(Blurred()), np.array([0.3]), np.ones(1))
    # Second differences of noise within +-1e-10 reach four times that.
    assert Blurred.noise < found <= 8.1 * Blurred.noise


@pytest.mark.parametrize("noisy", ["mass", "potential"])
def test_rounding_is_twice_the_second_difference_that_either_energy_leaves(noisy):
    """Values that jump by d to and fro have second differences of 2 d."""
    jump, looks = 1e-10, {"mass": 0, "potential": 0}

    def told(name):
        looks[name] += 1
        return 1.0 + jump * (looks[name] % 2) * (name == noisy)

    system = SimpleNamespace(
        mass=lambda q: np.array([[told("mass")]]), potential=lambda q: told("potential")
    )
    found = rounding_of(system, np.zeros(1), np.ones(1))
    assert found == pytest.approx(2 * 2 * jump / (1 + jump), rel=1e-5)


def test_noise_of_a_flow_does_not_keep_a_step_over_a_turning_point_from_converging():
    system, q, dt = AsArrays(Blurred()), np.array([0.3]), 0.05
    back = -acceleration(system, q, np.zeros(1)) * dt / 2  # turns half way: q1 - q0 is near zero
    phase = Phase(q, system.mass(q) @ back)
    noisy = advance(system, phase, dt, np.ones(1))
    assert (noisy.outcome, len(noisy.changes)) == ("iteration limit", LIMITS.sweeps)
    known = rounding_of(system, q, np.ones(1))
    found = advance(system, phase, dt, np.ones(1), rounding=known)
    assert found.outcome == "converged"
    assert len(found.changes) < 10
    before, after = level(system, phase), level(system, found.phase)
    assert after - before == pytest.approx(0, abs=known * abs(before))


def test_too_long_a_step_is_not_passed_off_as_converged():
    """The fixed point contracts by (omega dt)^2/4, omega = 1 here: not at dt = 4."""
    assert advance_one(Pendulum(), 0.8, 0.0, 4.0)[2] != "converged"
    assert advance_one(Pendulum(), 0.8, 0.0, 0.5, Limits(sweeps=2))[2] == "iteration limit"
    phase = Phase(START[0], Spinning().mass(START[0]) @ START[1])
    assert advance(Spinning(), phase, 20.0, LENGTHS).outcome != "converged"
    assert trajectory(Pendulum(), 0.8, 0.0, 4.0, 10).position.size == 1


def test_a_residual_that_is_not_finite_has_diverged():
    assert LIMITS.outcome(float("nan"), 1.0, 1.0, 1.0) == "diverged"
    assert LIMITS.outcome(1e9, 1.0, 1.0, 1.0) == "diverged"
    assert LIMITS.outcome(0.5, 1.0, 1.0, 1.0) is None
