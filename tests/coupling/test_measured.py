"""Modes of different units as one vector of lengths: nothing is gained or lost."""

from dataclasses import dataclass

import numpy as np
import pytest

from squat.coupling import (
    PREDICTORS,
    Coupling,
    Criterion,
    Load,
    NoAcceleration,
    State,
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


@dataclass(frozen=True)
class Sprung:
    """Three modes on springs in a fluid of some added mass."""

    mass: np.ndarray

    def load(self, trial, memory, dt):
        force = -0.3 * self.mass @ trial.acceleration - 5.0 * self.mass @ trial.position
        return Load(force, memory)


def test_a_step_in_lengths_is_the_step_in_the_modes_own_units():
    problem, dt = Sprung(MASSES), 0.1
    state = State((MOTION._replace(acceleration=-5 / 1.3 * MOTION.position),), memory=None)
    in_metres = Measured(problem, LENGTHS, np.array([True] * 3))
    steps = []
    for one, mass in ((Measured(problem, np.ones(3), np.array([True] * 3)), MASSES),
                      (in_metres, in_metres.mass)):  # fmt: skip
        made = corrected(mass, 0.3 * mass)
        criterion = Criterion(name="absolute", tolerance=1e-13, iterations=50, growth=1e8)
        coupling = Coupling(lambda _, made=made: made, INTEGRATORS["newmark"],
                            NoAcceleration(name="none"), PREDICTORS["hold"], criterion)  # fmt: skip
        steps.append(one.advanced(coupling, state, dt))
    for here, there in zip(*(step.state.past[0] for step in steps), strict=True):
        assert here == pytest.approx(there, rel=1e-11, abs=1e-13)


def test_growth_up_to_the_bound_is_not_yet_divergence():
    criterion = Criterion(name="absolute", tolerance=1e-6, iterations=9, growth=8.0)
    assert not criterion.lost(4.0, first=0.5)
    assert criterion.lost(np.nextafter(4.0, 5.0), first=0.5)
    assert criterion.lost(np.nan, first=0.5)
