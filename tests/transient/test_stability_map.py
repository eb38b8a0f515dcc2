"""Transients of a whole fleet against the separatrix, the orbits and single runs."""

import numpy as np
import pytest

from squat.config import compose, validate
from squat.errors import InputError
from squat.fluid.curves import Curves
from squat.stability.heave import HeaveSystem
from squat.stability.orbits import orbit
from squat.transient.fleet import GROUNDED, LIFTED, SAFE
from squat.transient.run import run as run_one
from squat.transient.stability_map import _fleet, _reduced, run

KEYS = ("mesh=coarse", "cases/map@_global_=small", "reduced.positions=12")


@pytest.fixture(scope="module")
def case():
    return validate(compose("stability_map", *KEYS)).case


@pytest.fixture(scope="module")
def data(case):
    return run(case)


@pytest.fixture(scope="module")
def fleet(case):
    loaded = _reduced(case)
    low, high = loaded.model.box.bounds
    curves = Curves.of(loaded.fluid(case.water, 0.0), low - 10, high - 10, 24)
    return _fleet(case, curves, -9.8)


def fates(fleet, heaves, currents, dt=0.1, end=500.0):
    rows = np.full((4, len(heaves)), np.nan)
    for numbers, found in fleet.march(np.array(heaves), np.array(currents), dt, end):
        rows[:, numbers] = found
    return rows


def test_every_transient_ends_on_the_side_of_the_separatrix_that_energy_says(data):
    assert data.attrs["undecided"] == 0
    assert data.attrs["disagreements"] == 0
    outcome = data["outcome"].values
    assert set(np.unique(outcome)) == {SAFE, GROUNDED, LIFTED}
    assert np.array_equal(outcome == GROUNDED, data["expected_safe"].values == 0)


def test_the_edge_closes_at_the_fold_like_a_root(data):
    """Near a fold U is cubic: both equilibria and the turn leave it with (V_f - V)^(1/2)."""
    near = data.isel(edge_current=slice(-12, None))
    width = (near["edge_turn"] - near["edge_barrier"]).values
    fold = near["edge_current"].values[-1]
    order = np.polyfit(np.log(fold - near["edge_current"].values[:-3]), np.log(width[:-3]), 1)[0]
    assert order == pytest.approx(0.5, abs=0.02)
    assert width[-1] < 0.1 * width[0]


def test_ships_a_millimetre_apart_part_at_the_separatrix(case, fleet, data):
    """Both branches, at a current of the map: the time step is far finer than the grid."""
    place = 15
    V = float(data["current"][place])
    low, high = float(data["barrier"][place]), float(data["turn"][place])
    assert high < 2
    starts = [low - 1e-3, low + 1e-3, high - 1e-3, high + 1e-3]
    outcome = fates(fleet, starts, [V] * 4)[0]
    assert outcome.tolist() == [GROUNDED, SAFE, SAFE, GROUNDED]


def test_ships_set_free_anywhere_in_any_current_have_a_fate(fleet):
    """From rest just above the ground a step of any length would go through the bottom."""
    heaves, currents = np.meshgrid([-9.79, -9.7, -5.0, 0.0, fleet.highest - 1e-6], [1, 3, 8, 100])
    outcome, time, clearance, gain = fates(fleet, heaves.ravel(), currents.ravel().astype(float))
    assert np.isfinite([outcome, time, clearance, gain]).all()
    assert set(outcome) <= {SAFE, GROUNDED, LIFTED}
    assert (clearance >= 0.2 - 1e-12).all()
    fast = (currents.ravel() == 100) & (heaves.ravel() < 0)
    assert (outcome[fast] == GROUNDED).all()


def test_least_clearance_is_the_turning_point_of_the_orbit(case, fleet):
    system = HeaveSystem.of(case.hull, case.water, fleet.curves)
    starts, currents = [-0.1, -3.0, 1.5], [2.0, 2.0, 1.0]
    _, _, clearance, _ = fates(fleet, starts, currents)
    for w, V, found in zip(starts, currents, clearance, strict=True):
        assert found - 10 == pytest.approx(orbit(system.at_current(V), w, 0.0).low, abs=1e-6)


def test_energy_is_kept_to_the_order_of_the_rule(fleet):
    gains = [abs(fates(fleet, [-3.0], [2.0], dt)[3, 0]) for dt in (0.4, 0.2)]
    assert np.log2(gains[0] / gains[1]) > 3.7


def test_time_to_grounding_is_that_of_a_single_run(case, fleet, data):
    _, (seconds,), _, _ = fates(fleet, [-0.1], [3.0], 0.02)
    keys = "force=variational", "coupling=energy_momentum", "time.steps_per_period=2000"
    one = run_one(
        validate(compose("transient", "mesh=coarse", "model=curves", "current=3", *keys)).case
    ).dataset
    assert one.attrs["status"] == "grounded"
    after, before = float(one["time"][-1]), float(one["time"][-2])
    assert before < seconds < after + 1e-4


def test_a_ship_that_starts_out_of_reach_is_refused_by_name(case):
    with pytest.raises(InputError, match=r"heaves\.least=-11"):
        run(validate(compose("stability_map", *KEYS, "heaves.least=-11")).case)
