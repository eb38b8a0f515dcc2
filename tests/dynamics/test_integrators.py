"""The integrators' affine ties and their orders."""

import numpy as np
import pytest

from squat.dynamics import INTEGRATORS, Motion, TimeGrid


def motion(t):
    return Motion(*(np.array([value]) for value in (np.sin(t), np.cos(t), -np.sin(t))))


@pytest.mark.parametrize("name", INTEGRATORS)
def test_ties_are_exact_for_a_parabola_from_its_start(name):
    """q = t^2/2 with q' = t, q'' = 1: every formula here has at least that degree."""
    dt = 0.25
    past = (Motion(np.array([0.0]), np.array([0.0]), np.array([1.0])),)
    for n in range(1, 5):
        t = n * dt
        new = INTEGRATORS[name].kinematics(past, dt).at_position(np.array([t**2 / 2]))
        assert new.acceleration == pytest.approx(1, abs=1e-12)
        # The centred velocity stands half a step back on each side: at t_n, not t_{n+1}.
        at = t - dt if name == "centred" else t
        assert new.velocity == pytest.approx(at, abs=1e-12)
        past = (new, *past[:2])


@pytest.mark.parametrize("name", INTEGRATORS)
def test_position_and_acceleration_give_the_same_motion(name):
    ties = INTEGRATORS[name].kinematics((motion(0.3), motion(0.2)), 0.1)
    by_position = ties.at_position(np.array([0.42]))
    by_acceleration = ties.at_acceleration(by_position.acceleration)
    for one, other in zip(by_position, by_acceleration, strict=True):
        assert one == pytest.approx(other, rel=1e-12)


def test_newmark_is_eq_8():
    dt, past, a = 0.1, motion(0.3), np.array([-0.7])
    new = INTEGRATORS["newmark"].kinematics((past,), dt).at_acceleration(a)
    q, v, a0 = past
    assert new.position == pytest.approx(q + dt * v + dt**2 / 4 * (a0 + a), rel=1e-14)
    assert new.velocity == pytest.approx(v + dt / 2 * (a0 + a), rel=1e-13)


def test_centred_is_eq_17_and_starts_from_a_taylor_step():
    dt, a = 0.1, np.array([-0.7])
    past = motion(0.3), motion(0.2)
    new = INTEGRATORS["centred"].kinematics(past, dt).at_acceleration(a)
    q, before = past[0].position, past[1].position
    assert new.position == pytest.approx(2 * q - before + dt**2 * a, rel=1e-14)
    assert new.velocity == pytest.approx((new.position - before) / (2 * dt), rel=1e-13)
    first = INTEGRATORS["centred"].kinematics(past[:1], dt).at_acceleration(past[0].acceleration)
    # With w''^0 itself the first step is w^0 + dt w'^0 + dt^2/2 w''^0.
    taylor = q + dt * past[0].velocity + dt**2 / 2 * past[0].acceleration
    assert first.position == pytest.approx(taylor, rel=1e-14)


def test_time_grid_counts_steps():
    grid = TimeGrid(periods=3, steps_per_period=70)
    assert grid.steps == 210
    assert grid.step(2 * np.pi) == pytest.approx(1 / 70)
    assert TimeGrid(periods=1e-9, steps_per_period=1).steps == 1
