"""The simulator against independent integration, invariants and statics."""

import copy
import math
from itertools import pairwise

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from squat.dynamics import Motion, RigidBody
from squat.errors import InputError
from squat.fluid.curves import Curves
from squat.fluid.energy import ShipEnergy, still_water
from squat.mesh import PositionError
from squat.reduced import Simulator

SPRING = 1000 * 9.81 * 40


@pytest.fixture(scope="module")
def set_free(heave):
    def make(w=-0.1, current=1.0, **options):
        return Simulator(heave.loaded, heave.case.water, w, current, **options)

    return make


def drive(t):
    return 1.2 + 0.2 * math.sin(0.3 * t)


def test_varying_current_gives_the_motion_of_the_full_meshs_curves(heave, set_free):
    """solve_ivp on curves of the full solver, in w and w', with the -b dV/dt term."""
    curves = Curves.of(heave.full(), -8.0, 3.0)
    mass = 1000.0 * 400

    def rates(t, y):
        w, v = y
        V, R = drive(t), 0.06 * math.cos(0.3 * t)
        (_, b, c), (da, _, dc) = curves.values(w), curves.first(w)
        force = V**2 / 2 * (da + 1000 * 40) - SPRING * w - b * R - dc * v**2 / 2
        return v, force / (mass + c)

    times = np.arange(1, 401) * 0.1
    exact = solve_ivp(rates, (0, 40), (-0.1, 0), "DOP853", times, rtol=1e-11, atol=1e-12).y
    ship = set_free(current=drive(0), max_step=0.02)
    found = []
    for t in times:
        # The drive is linear over a step: ten of them between two outputs.
        for part in range(9, -1, -1):
            state = ship.step(0.01, drive(t - 0.01 * part))
        found.append((state.heave, state.heave_velocity))
    # V is linear over 0.01 s: off by (0.01)^2/8 V'' = 2e-7 m/s, its rate by 9e-5 m/s2 now and then.
    assert np.abs(np.array(found).T - exact).max() < 5e-6


def test_energy_is_kept_to_fourth_order_in_a_steady_current(heave, set_free):
    still = still_water(heave.model.submesh, heave.case.water)
    body = RigidBody(("heave",), 400e3, 0.0, 9.81)
    ship = ShipEnergy(body, still, heave.model, 2.0)

    def drift(dt):
        simulator = set_free(-0.5, 2.0, max_step=dt)
        energies = []
        for _ in range(round(40 / dt)):
            s = simulator.step(dt, 2.0)
            q, v = np.array([s.heave]), np.array([s.heave_velocity])
            energies.append(ship.energies(Motion(q, v, 0 * v)).conserved)
        return abs(energies[-1] - energies[0])

    errors = [drift(dt) for dt in (0.8, 0.4, 0.2)]
    # E of an explicit rule drifts one order higher than its error.
    assert all(np.log2(a / b) > 3.7 for a, b in pairwise(errors))


def test_power_of_the_ends_is_what_ship_and_water_gain(heave, set_free):
    """d/dt (T + U_h + m g w) + q' dU_B/dq = V d/dt (V a + b q'), whatever V does.

    U_B = rho V^2 A/2 holds V too: its change by V alone is no work.
    """
    still = still_water(heave.model.submesh, heave.case.water)
    ship = ShipEnergy(RigidBody(("heave",), 400e3, 0.0, 9.81), still, heave.model, 0.0)
    simulator = set_free(-0.3, drive(0), max_step=0.05)
    rows = []
    for n in range(1, 801):
        s = simulator.step(0.05, drive(0.05 * n))
        q, v = np.array([s.heave]), np.array([s.heave_velocity])
        now = ship.at_current(s.current).energies(Motion(q, v, 0 * v))
        rows.append((now.total, now.supply / s.current, s.current, s.heave))
    total, flux, V, w = np.array(rows).T
    middle = (V[1:] + V[:-1]) / 2
    supplied = (middle * np.diff(flux)).sum()
    by_current = (-1000 * 40 * (w[1:] + w[:-1]) / 2 * np.diff(V**2 / 2)).sum()
    assert total[-1] - total[0] - by_current == pytest.approx(supplied, rel=1e-4)
    assert abs(supplied) > 1e4


def test_constant_force_moves_the_mean_by_force_over_stiffness(set_free):
    force = 0.01 * SPRING
    ship = set_free(0.0, 0.0)
    ship.step(1e-9, 0.0, force)
    heaves = [ship.step(0.1, 0.0, force).heave for _ in range(4000)]
    # Small oscillation about F/(rho g L) = 0.01 m between 0 and 0.02 m.
    assert (max(heaves) + min(heaves)) / 2 == pytest.approx(0.01, rel=1e-2)
    assert min(heaves) == pytest.approx(0, abs=1e-5)


def test_long_steps_are_cut_and_answers_do_not_depend_on_company(set_free):
    one, two, other = set_free(), set_free(), set_free(-2.0, 0.5)
    for _ in range(20):
        a = one.step(0.5, 1.3, 1e3)
        other.step(0.25, 2.0)
        b = two.step(0.5, 1.3, 1e3)
    assert a == b
    fine = set_free(max_step=1.0)
    assert fine.step(1.0, 1.0).heave == pytest.approx(set_free().step(1.0, 1.0).heave, abs=1e-5)


def test_a_copy_goes_its_own_way_from_where_the_ship_is(set_free):
    ship = set_free()
    ship.step(0.5, 1.3)
    kept = copy.copy(ship)
    ahead = [ship.step(0.5, 2.0) for _ in range(5)]
    assert kept.state.time == 0.5
    other = copy.copy(kept)
    assert [kept.step(0.5, 2.0) for _ in range(5)] == ahead
    assert other.step(0.5, 0.3) != ahead[0]


def test_grounded_ship_stays_where_it_touched(set_free):
    ship = set_free(-0.1, 3.0)
    while not (state := ship.step(0.1, 3.0)).grounded:
        assert state.time < 100
    assert 0 < state.clearance < 0.5
    assert state.heave_velocity == 0
    later = ship.step(1.0, 0.0)
    assert (later.heave, later.grounded, later.time) == (state.heave, True, state.time + 1.0)


def test_a_long_step_ends_where_short_ones_would_ground(set_free):
    """The step that meets the bottom loses its last part alone, of 0.1 s."""
    short, long = set_free(-0.1, 2.6), set_free(-0.1, 2.6)
    while not (state := short.step(0.1, 2.6)).grounded:
        assert state.time < 100
    while not (coarse := long.step(1.0, 2.6)).grounded:
        assert coarse.time < 100
    assert coarse.clearance == pytest.approx(state.clearance, abs=1e-9)


def test_a_step_out_of_the_model_leaves_the_ship_where_it_was(set_free):
    ship, twin = set_free(), set_free()
    for one in (ship, twin):
        before = one.step(0.5, 1.2, 1e3)
    with pytest.raises(PositionError):
        ship.step(60.0, 1.8, external_force=4e6)
    assert ship.state == before
    assert ship.step(0.02, 1.2) == twin.step(0.02, 1.2)


def test_heave_and_pitch_follow_lagrange_on_the_full_mesh(pitch):
    """solve_ivp on the full solver's energies, gyroscopic force and -b dV/dt included."""
    full, water = pitch.full(), pitch.case.water
    still = still_water(pitch.model.submesh, water)
    body = RigidBody(("heave", "pitch"), 400e3, 400e3 * 100, 9.81)
    ship = ShipEnergy(body, still, full, 0.0)

    def rates(t, y):
        q, v = y[:2], y[2:]
        c, s = full.coefficients(q), full.slopes(q)
        here = ship.at_current(1.0 + 0.02 * t)
        bend = np.einsum("ijk,j,k->i", s.c, v, v) - np.einsum("jki,j,k->i", s.c, v, v) / 2
        force = here.gyroscopic(q) @ v - here.gradient(q) - bend - 0.02 * c.b
        return np.concatenate([v, np.linalg.solve(here.mass(q), force)])

    exact = solve_ivp(rates, (0, 3), (-0.2, 0.002, 0, 0), rtol=1e-7, atol=1e-9).y[:, -1]
    both = Simulator(pitch.loaded, water, (-0.2, 0.002), 1.0)
    for n in range(1, 31):
        s = both.step(0.1, 1.0 + 0.002 * n)
    found = np.array([s.heave, s.pitch, s.heave_velocity, s.pitch_velocity])
    # The model with pitch has forces to 1e-4 here, the smallest clearances included.
    assert found == pytest.approx(exact, rel=1e-3, abs=1e-6)
    assert abs(s.pitch) > 1e-4


@pytest.mark.parametrize(
    ("arguments", "key"),
    [((0.0, 1.0), "dt=0"), ((0.1, -1.0), "current=-1"), ((0.1, 1.0, math.nan), "external_force")],
)
def test_bad_steps_are_refused_by_name(set_free, arguments, key):
    with pytest.raises(InputError, match=key):
        set_free().step(*arguments)


def test_bad_starts_are_refused_by_name(heave, set_free):
    with pytest.raises(InputError, match=r"position=.*give heave"):
        set_free((-0.1, 0.0))
    with pytest.raises(PositionError):
        set_free(-9.99)
    with pytest.raises(InputError, match="density"):
        Simulator(heave.loaded, type(heave.case.water)(density=1025.0, gravity=9.81), -0.1, 1.0)
