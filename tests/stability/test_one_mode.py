"""Roots, folds, periods, separatrices and dynamic limits of systems with exact answers."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.integrate import solve_ivp

from squat.errors import InputError
from squat.stability.branches import equilibria, least_slope
from squat.stability.dynamic import dynamic_squat_speed, margin
from squat.stability.fold import squat_speed
from squat.stability.one_mode import energy
from squat.stability.orbits import linear_period, orbit
from squat.stability.separatrix import bounded, separatrix, well
from tests.stability.systems import Cubic, Pendulum

CUBIC = Cubic(0.0)


@given(st.floats(1e-9, 2.4999999))
def test_roots_of_the_cubic_are_found_however_close_to_merging(current):
    mode = CUBIC.at_current(current)
    r = np.sqrt(mode.r2)
    lower, upper = equilibria(mode)
    assert (lower.stable, upper.stable) == (False, True)
    # Near the fold dU/dw is flat: rounding of it moves a root by eps/r.
    assert lower.heave == pytest.approx(-3 - r, abs=1e-14 + 1e-14 / r)
    assert upper.heave == pytest.approx(-3 + r, abs=1e-14 + 1e-14 / r)


@pytest.mark.parametrize("place", [-7.123, -3.0, 1.77])
def test_fold_of_the_cubic_is_bracketed_to_1e_8(place):
    family = Cubic(0.0, fold_place=place).at_current
    fold = squat_speed(family)
    assert fold.width <= 1e-8
    assert abs(fold.speed - 2.5) <= fold.width / 2
    assert fold.sinkage == pytest.approx(place, abs=1e-7)
    assert len(equilibria(family(fold.speed - fold.width))) == 2
    assert equilibria(family(fold.speed + fold.width)) == []


def test_a_system_without_a_fold_is_refused_by_name():
    with pytest.raises(InputError, match=r"channel\.depth: no squat speed below 1000 m/s"):
        squat_speed(lambda V: Pendulum())


@given(st.floats(1e-3, 2.99))
def test_period_of_the_pendulum_is_the_elliptic_integral(amplitude):
    pendulum = Pendulum()
    found = orbit(pendulum, amplitude, 0.0)
    assert found.high == amplitude
    assert found.low == pytest.approx(-amplitude, abs=1e-9)
    # Rounding of E - U, eps/amplitude^2, is what limits small amplitudes.
    assert found.period == pytest.approx(
        pendulum.period(amplitude), rel=1e-11 + 1e-14 / amplitude**2
    )


@given(st.floats(0.0, 2.4), st.floats(0.01, 0.999))
def test_period_in_the_cubic_well_is_the_elliptic_integral(current, depth):
    mode = CUBIC.at_current(current)
    r = np.sqrt(mode.r2)
    total = -2 / 3 * r**3 + depth * 4 / 3 * r**3
    velocity = np.sqrt(2 * (total + 2 / 3 * r**3) / mode.inertia)
    found = orbit(mode, -3 + r, velocity)
    assert found.period == pytest.approx(mode.period(total), rel=1e-9)


def test_linear_period_is_the_limit_of_small_motion():
    mode = CUBIC.at_current(1.0)
    r = np.sqrt(mode.r2)
    exact = 2 * np.pi * np.sqrt(mode.inertia / (2 * r))
    assert linear_period(mode, -3 + r) == pytest.approx(exact, rel=1e-9)
    assert np.isnan(linear_period(mode, -3 - r))
    small = [orbit(mode, -3 + r, v).period / exact - 1 for v in (2e-2, 1e-2)]
    assert small[0] / small[1] == pytest.approx(4, rel=1e-2)  # amplitude squared
    assert 0 < small[1] < 1e-4


def test_lost_and_lifted_orbits_have_no_period():
    mode = CUBIC.at_current(1.0)
    r = np.sqrt(mode.r2)
    lost = orbit(mode, -3 + 2.01 * r, 0.0)
    assert np.isnan([lost.low, lost.period]).all()
    lifted = orbit(Pendulum(), 0.0, 100.0)
    assert np.isnan([*lifted]).all()


@given(st.floats(-2.9, 1.9), st.floats(0.0, 0.5))
def test_dynamic_squat_speed_is_where_the_start_reaches_the_barrier(heave, velocity):
    """M v^2/2 = (x + r)^2 (2 r - x)/3, the least r of which loses the ship."""
    fold = squat_speed(CUBIC.at_current)
    found = dynamic_squat_speed(CUBIC.at_current, fold, heave, velocity)
    x, r = heave + 3, np.sqrt(2.5**2 - found**2)
    kinetic = CUBIC.inertia * velocity**2 / 2
    assert (x + r) ** 2 * (2 * r - x) / 3 == pytest.approx(kinetic, abs=1e-8)
    if velocity == 0:
        assert found == pytest.approx(np.sqrt(2.5**2 - (x / 2) ** 2), abs=1e-10)
    assert dynamic_squat_speed(CUBIC.at_current, fold, heave, -velocity) == found


@given(st.floats(-5.4, -3.1))
def test_released_below_the_fold_the_unstable_root_itself_is_the_limit(heave):
    fold = squat_speed(CUBIC.at_current)
    found = dynamic_squat_speed(CUBIC.at_current, fold, heave, 0.0)
    assert found == pytest.approx(np.sqrt(2.5**2 - (heave + 3) ** 2), rel=1e-10)


def test_a_start_that_grounds_in_still_water_has_limit_zero():
    fold = squat_speed(CUBIC.at_current)
    assert dynamic_squat_speed(CUBIC.at_current, fold, -1.0, 20.0) == 0


def test_separatrix_has_the_energy_of_the_barrier_and_its_exact_area():
    mode = CUBIC.at_current(1.5)
    r = np.sqrt(mode.r2)
    loop = separatrix(mode, 101)
    top, bottom = well(mode)
    assert (top, bottom) == pytest.approx((-3 - r, -3 + r))
    assert loop.heave[[0, -1]] == pytest.approx([-3 - r, -3 + 2 * r])
    along = [energy(mode, w, v) for w, v in zip(loop.heave, loop.velocity, strict=True)]
    assert along == pytest.approx(np.full(101, 2 / 3 * r**3), rel=1e-12)
    # The half loop ends in a corner at the saddle: the rule is of fourth order there.
    assert loop.area == pytest.approx(mode.loop_area(), rel=1e-6)
    assert np.isnan(separatrix(CUBIC.at_current(2.6), 11).area)


@pytest.mark.parametrize("damping", [0.3, 2.0])
def test_inside_the_separatrix_any_damping_leads_to_the_stable_equilibrium(damping):
    mode = CUBIC.at_current(1.5)
    loop = separatrix(mode, 21)
    stable = well(mode)[1]
    for n in (1, 10, 19):
        for share in (-0.98, 0.98):
            start = [loop.heave[n], share * loop.velocity[n]]

            def rate(t, y):
                return [y[1], -(mode.slope(y[0]) + damping * y[1]) / mode.inertia]

            end = solve_ivp(rate, (0, 150), start, rtol=1e-6, atol=1e-8).y[:, -1]
            assert end == pytest.approx([stable, 0], abs=1e-2)


def test_margin_changes_sign_at_the_separatrix():
    mode = CUBIC.at_current(1.5)
    loop = separatrix(mode, 31)
    for w, v in zip(loop.heave[1:-1], loop.velocity[1:-1], strict=True):
        assert (
            margin(mode, float(w), 0.999 * float(v)) > 0 > margin(mode, float(w), 1.001 * float(v))
        )


def test_separatrix_that_leaves_at_the_top_keeps_the_energy_up_to_there():
    mode = Cubic(0.0, fold_speed=5.0)  # it would turn at -3 + 2 r = 7, above the interval
    loop = separatrix(mode, 51)
    assert loop.heave[[0, -1]] == pytest.approx([-8.0, mode.interval.high])
    along = [energy(mode, w, v) for w, v in zip(loop.heave, loop.velocity, strict=True)]
    assert along == pytest.approx(np.full(51, 2 / 3 * 5.0**3), rel=1e-12)
    assert np.isnan(loop.area)


@pytest.mark.parametrize("scale", [1e-3, 1.0, 1e6])
def test_least_slope_lies_between_samples_whatever_its_unit(scale):
    class Scaled(Cubic):
        def slope(self, w):
            return scale * (super().slope(w) + 1e-9)

    place, least = least_slope(Scaled(2.5, fold_place=-3.021))
    assert place == pytest.approx(-3.021, abs=1e-6)
    assert least == pytest.approx(scale * 1e-9, rel=1e-2)


def test_bounded_motion_is_that_inside_the_separatrix():
    mode = CUBIC.at_current(1.5)
    loop = separatrix(mode, 21)
    w, v = float(loop.heave[10]), float(loop.velocity[10])
    assert bounded(mode, w, 0.999 * v)
    assert not bounded(mode, w, 1.001 * v)
