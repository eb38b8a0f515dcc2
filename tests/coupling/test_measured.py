"""Modes of different units as one vector of lengths: nothing is gained or lost."""

import numpy as np
import pytest

from squat.coupling import (
    PREDICTORS,
    Coupling,
    Criterion,
    Load,
    NoAcceleration,
    State,
    advance,
    corrected,
)
from squat.coupling.measured import Measured
from squat.dynamics import INTEGRATORS, Motion

LENGTHS = np.array([1.0, 1.0, 20.0])
MASSES = np.array([[4.0, 0.5, 3.0], [0.5, 4.0, -2.0], [3.0, -2.0, 900.0]])
MOTION = Motion(*(np.array([0.3, -0.2, 0.01]) * k for k in (1.0, 2.0, -3.0)))


class Still:
    mass = MASSES


def measured(*free):
    return Measured(Still(), LENGTHS, np.array(free))


def test_kinetic_energy_is_the_same_in_either_unit():
    both = measured(True, True, True)
    v, x = MOTION.velocity, both.outward(MOTION).velocity
    assert x @ both.mass @ x == pytest.approx(v @ MASSES @ v, rel=1e-14)


def test_a_motion_turned_outward_and_back_is_itself():
    one = measured(True, True, True)
    assert one.outward(MOTION).position == pytest.approx(MOTION.position * LENGTHS)
    for there, here in zip(one.inward(one.outward(MOTION)), MOTION, strict=True):
        assert there == pytest.approx(here, rel=1e-14)


def test_free_and_held_modes_exchange_nothing():
    found = measured(True, False, True).mass
    apart = np.array([[0, 1, 0], [1, 0, 1], [0, 1, 0]], bool)
    assert (found[apart] == 0).all()
    assert found[0, 2] == pytest.approx(MASSES[0, 2] / 20)


class Sprung:
    """Springs of the same frequency in each mode, and no water: the iteration ends by itself."""

    mass = MASSES

    def load(self, trial, memory, dt):
        return Load(-2.0 * MASSES @ trial.position, memory)


def coupling(mass, m_add):
    scheme = corrected(mass, m_add)
    return Coupling(
        lambda motion: scheme,
        INTEGRATORS["backward"],
        NoAcceleration(name="none"),
        PREDICTORS["linear"],
        Criterion(name="absolute", tolerance=1e-13, iterations=200, growth=1e8),
    )


def test_steps_in_metres_are_the_steps_in_the_modes_own_units():
    """q' = x'/l makes l^-1 M l^-1 x'' = l^-1 F of M q'' = F: one equation, so equal steps."""
    whole = Measured(Sprung(), LENGTHS, np.array([True, True, True]))
    added = MASSES / 4
    plain, metric = State((MOTION,), 0), State((MOTION,), 0)
    for _ in range(5):
        plain = advance(Sprung(), coupling(MASSES, added), plain, 0.1).state
        step = whole.advanced(coupling(whole.mass, whole.matrix(added)), metric, 0.1)
        assert step.status == "converged"
        metric = step.state
        for past, same in zip(metric.past, plain.past, strict=True):
            # One iteration shrinks an error to a quarter or less: 1e-13/(1 - 1/4), over dt^2.
            for there, here in zip(past, same, strict=True):
                assert there == pytest.approx(here, abs=1e-10)


def test_a_held_mode_keeps_its_velocity():
    """It does so to the tolerance: no force reaches it, whatever the others do."""
    held = Measured(Sprung(), LENGTHS, np.array([True, False, True]))
    motion = MOTION._replace(acceleration=MOTION.acceleration * np.array([1.0, 0.0, 1.0]))
    state = State((motion,), 0)
    for _ in range(5):
        state = held.advanced(coupling(held.mass, held.matrix(MASSES / 4)), state, 0.1).state
    assert len(state.past) > 1
    assert state.motion.velocity[1] == pytest.approx(MOTION.velocity[1], abs=1e-12)
    assert state.motion.position[1] == pytest.approx(
        MOTION.position[1] + 0.5 * MOTION.velocity[1], abs=1e-12
    )
    assert abs(state.motion.velocity[0] - MOTION.velocity[0]) > 1e-2
