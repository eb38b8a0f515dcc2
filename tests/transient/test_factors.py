"""The predicted amplification factor of several modes."""

from types import SimpleNamespace

import numpy as np
import pytest

from squat.fluid.model import Coefficients, Slopes
from squat.fluid.rates import RATES
from squat.fluid.variational import dynamic_force, gyroscopic
from squat.transient.factors import _damping

V = 1.3


def case(force, s1=0.5, rate="backward"):
    coupling = SimpleNamespace(ties=SimpleNamespace(s1=s1), potential_rate=rate)
    return SimpleNamespace(force=force, current=V, coupling=coupling)


@pytest.fixture
def slopes():
    random = np.random.default_rng(3)
    c = random.normal(size=(3, 3, 3))
    return Slopes(random.normal(size=3), random.normal(size=(3, 3)), c + c.transpose(1, 0, 2))


def test_in_one_mode_it_is_that_of_heave_alone():
    one, v = Slopes(np.ones(1), np.array([[0.7]]), np.array([[[0.2]]])), np.array([0.4])
    db, dc = 0.7, 0.2
    s1, s2 = 0.5, RATES["backward"].s2
    assert _damping(case("integrated"), one, v) == pytest.approx((s1 - s2) * (V * db + 0.4 * dc))
    assert _damping(case("variational"), one, v) == pytest.approx(-s1 * dc * 0.4)


def test_of_the_variational_force_it_is_the_rate_of_that_force_by_velocity(slopes):
    v, step = np.array([0.3, -0.5, 0.2]), 1e-4
    none = np.zeros(3)
    still = Coefficients(0.0, none, np.zeros((3, 3)))
    ahead, behind = (
        np.array([dynamic_force(still, slopes, V, v + s * e, none) for e in step * np.eye(3)])
        for s in (1, -1)
    )
    rate = (ahead - behind).T / (2 * step)
    assert _damping(case("variational", s1=1.0), slopes, v) == pytest.approx(rate, rel=1e-9)


def test_with_all_terms_at_one_time_a_ship_at_rest_has_the_gyroscopic_force_alone(slopes):
    s1 = RATES["backward"].s2
    found = _damping(case("integrated", s1), slopes, np.zeros(3))
    assert found == pytest.approx(s1 * gyroscopic(slopes, V), rel=1e-14)
