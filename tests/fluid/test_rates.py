"""Each formula is exact for polynomials of its order and has its s2."""

import numpy as np
import pytest

from squat.fluid.rates import RATES, Levels


@pytest.mark.parametrize("name", RATES)
def test_rate_is_exact_for_polynomials_of_its_order(name):
    dt, t = 0.1, 0.7
    rate = RATES[name]
    at = t - dt if name == "centred" else t
    for degree in range(rate.order + 1):
        old = Levels(
            np.array([(t - dt) ** degree]),
            np.array([(t - 2 * dt) ** degree]),
            np.array([degree * (t - dt) ** max(degree - 1, 0)]),
        )
        exact = degree * at ** max(degree - 1, 0)
        assert rate(np.array([t**degree]), old, dt) == pytest.approx(exact, abs=1e-13)


@pytest.mark.parametrize("name", RATES)
def test_s2_is_the_weight_of_the_new_level(name):
    old = Levels(*np.ones((3, 1)))
    step = RATES[name](np.array([3.0]), old, 0.5) - RATES[name](np.array([2.0]), old, 0.5)
    assert step == pytest.approx(RATES[name].s2 / 0.5)
