"""Modes of different units as one vector of lengths: nothing is gained or lost."""

import numpy as np
import pytest

from squat.coupling.measured import Measured
from squat.dynamics import Motion

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
