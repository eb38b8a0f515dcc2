"""Measured contraction equals the closed form, and convergence is |G| < 1."""

from dataclasses import replace

import numpy as np
import pytest

from squat.coupling.amplification import (
    amplification_factor,
    amplification_matrix,
    limit_mass_ratio,
    smallest_added_mass,
)
from squat.dynamics import INTEGRATORS
from squat.piston.run import steps
from squat.piston.study import with_ratios

MASS_RATIOS = (0.2, 0.5, 0.95, 1.0, 2.0, 10.0)
ADDED_MASS_RATIOS = (0.0, 0.3, 0.5, 1.5, 3.0)
STEPS = (12, 70, 400)


def grid(case):
    base = case("piston")
    for n in STEPS:
        time = replace(base.time, steps_per_period=n, periods=2 / n)
        for m_f in MASS_RATIOS:
            for m_add in ADDED_MASS_RATIOS:
                yield with_ratios(replace(base, time=time), m_f, m_add)


@pytest.mark.parametrize("integrator", ["newmark", "centred"])
def test_measured_contraction_is_the_predicted_factor(case, integrator):
    for cell in grid(case):
        run = replace(cell, integrator=integrator)
        predicted = run.amplification()
        # Where |G| is small, one or two residuals above round-off are left to measure by.
        first = steps(run)[0]
        assert first.contraction == pytest.approx(predicted, abs=1e-6), run


@pytest.mark.parametrize("integrator", ["newmark", "centred"])
def test_converges_exactly_when_the_factor_is_below_one(case, integrator):
    seen = set()
    for cell in grid(case):
        run = replace(cell, integrator=integrator)
        converged = steps(run)[-1].status == "converged"
        assert converged == (abs(run.amplification()) < 1), run
        seen.add(converged)
    assert seen == {True, False}


def test_closed_forms_are_those_of_the_paper():
    """Eq. (11), its centred and its corrected form, as printed in section 2.2 and 2.3."""
    m, m_f, rho_g_S, dt, m_add = 3.0, 2.0, 7.0, 0.1, 1.5
    newmark, centred = INTEGRATORS["newmark"], INTEGRATORS["centred"]
    args = (m, m_f, 2 * rho_g_S, dt)
    assert amplification_factor(*args, newmark) == pytest.approx(
        -(2 * m_f + dt**2 * rho_g_S) / (2 * m)
    )
    assert amplification_factor(*args, centred) == pytest.approx(-(m_f + dt**2 * 2 * rho_g_S) / m)
    assert amplification_factor(*args, newmark, m_add) == pytest.approx(
        (2 * (m_add - m_f) - dt**2 * rho_g_S) / (2 * (m_add + m))
    )
    assert amplification_factor(*args, centred, m_add) == pytest.approx(
        (m_add - m_f - 2 * dt**2 * rho_g_S) / (m_add + m)
    )


@pytest.mark.parametrize("name", ["newmark", "centred"])
def test_correction_is_not_unconditional_but_has_a_sharp_threshold(name):
    """`paper inconsistent`: the paper's own corrected factor exceeds one below this m_add."""
    m, m_f, k, dt = 1.0, 10.0, 40.0, 0.05
    least = smallest_added_mass(m, m_f, k, dt, INTEGRATORS[name])
    assert least > 0
    for m_add, converges in ((least * (1 - 1e-9), False), (least * (1 + 1e-9), True)):
        factor = amplification_factor(m, m_f, k, dt, INTEGRATORS[name], m_add)
        assert (abs(factor) < 1) == converges


@pytest.mark.parametrize("name", ["newmark", "centred"])
@pytest.mark.parametrize("steps_per_period", [10, 70])
def test_limit_mass_ratio_has_a_factor_of_one(name, steps_per_period):
    ratio = limit_mass_ratio(steps_per_period, INTEGRATORS[name])
    stiffness = 1.0 + ratio  # omega = 1 for m = 1
    factor = amplification_factor(
        1.0, ratio, stiffness, 2 * np.pi / steps_per_period, INTEGRATORS[name]
    )
    assert factor == pytest.approx(-1, abs=1e-14)


def test_matrix_form_reduces_to_the_scalar_one():
    newmark = INTEGRATORS["newmark"]
    parts = [np.diag(values) for values in ([1.0, 2.0], [3.0, 1.0], [5.0, 6.0])]
    added = np.diag([2.5, 1.5])
    matrix = amplification_matrix(parts[0], parts[1], parts[2], 0.1, newmark, added)
    scalars = [
        amplification_factor(*(p[i, i] for p in parts), 0.1, newmark, added[i, i]) for i in range(2)
    ]
    assert matrix == pytest.approx(np.diag(np.array(scalars, float)), abs=1e-15)
