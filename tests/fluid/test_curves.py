"""Curves of the energy coefficients, and a ship that moves along them for a long time."""

from functools import cache

import numpy as np
import pytest

from squat.dynamics import RigidBody
from squat.dynamics.energy_momentum import Phase, advance
from squat.dynamics.one_mode import trajectory
from squat.errors import InputError
from squat.fluid.curves import Curves
from squat.fluid.energy import ShipEnergy, still_water
from squat.fluid.heave import HeaveEnergy
from squat.fluid.potential import PotentialFluid
from squat.mesh import PositionError, subdivided, submesh
from squat.water import Water
from tests.hulls import CHANNEL, hull

WATER = Water(density=1000.0, gravity=9.81)
RECTANGLE = hull("rectangle")
WEIGHT = WATER.density * WATER.gravity * 400.0 * 10.0  # m g T
HEAVES = np.array([-9.5, -7.3, -1.234, 0.0, 2.1, 4.2])


@cache
def fluid():
    return PotentialFluid(
        subdivided(submesh(RECTANGLE, CHANNEL, ("heave",)), 6), WATER, "rigid_lid", 0.0
    )


@cache
def curves(points=16):
    return Curves.of(fluid(), -9.6, 4.5, points)


def ship(current, model=None):
    body = RigidBody(("heave",), 4e5, 0.0, WATER.gravity)
    still = still_water(fluid().mesh.submesh, WATER)
    return ShipEnergy(body, still, model or curves(), current)


@cache
def exact():
    rows = [(fluid().coefficients(np.array([w])), fluid().slopes(np.array([w]))) for w in HEAVES]
    values = np.array([[v.a, v.b[0], v.c[0, 0]] for v, _ in rows]).T
    return values, np.array([[s.a[0], s.b[0, 0], s.c[0, 0, 0]] for _, s in rows]).T


def errors(points):
    found, (values, slopes) = curves(points), exact()
    apart = np.abs(found.first(HEAVES) - slopes) / np.abs(slopes).max(axis=1, keepdims=True)
    return np.abs(found.values(HEAVES) / values - 1).max(), apart.max()


def test_curves_converge_geometrically_in_their_points():
    """Errors fall by a fixed factor a point until solves (1e-12) and their slopes stop them."""
    values, slopes = np.array([errors(points) for points in (6, 8, 10, 12)]).T
    assert np.all(values[1:] < values[:-1] / 8)
    assert np.all(slopes[1:] < slopes[:-1] / 5)
    assert errors(16)[0] < 1e-9
    assert errors(16)[1] < 1e-8


def test_derivatives_of_the_curves_are_those_of_the_curves():
    found, w, h = curves(), HEAVES[1:-1], 1e-4
    slope = (found.values(w + h) - found.values(w - h)) / (2 * h)
    assert found.first(w) == pytest.approx(slope, rel=1e-6, abs=1e-3)
    bend = (found.first(w + h) - found.first(w - h)) / (2 * h)
    assert found.second(w) == pytest.approx(bend, rel=1e-6, abs=1e-3)


def test_one_position_is_asked_for_as_of_any_model():
    model, q = curves(), np.array([-1.3])
    for one, other in zip(model.coefficients(q), fluid().coefficients(q), strict=True):
        assert np.shape(one) == np.shape(other)
        assert one == pytest.approx(other, rel=1e-9)
    for one, other in zip(model.slopes(q), fluid().slopes(q), strict=True):
        assert np.shape(one) == np.shape(other)
        assert one == pytest.approx(other, rel=1e-7)


def test_positions_beyond_the_curves_are_refused():
    low, high = curves().ends
    assert (low, high) == pytest.approx((-9.6, 4.5))
    curves().values([low, high])
    for w in (low - 1e-6, high + 1e-6, -11.0, np.nan):
        with pytest.raises(PositionError, match="beyond the curves"):
            curves().values(w)
    with pytest.raises(PositionError, match="beyond the curves"):
        HeaveEnergy(ship(2.0))(low - 1e-6)


def test_plain_floats_are_the_arrays_numbers():
    vessel, w = ship(2.0), -1.3
    q = np.array([w])
    M, U, dM, dU = HeaveEnergy(vessel)(w)
    assert pytest.approx(vessel.mass(q)[0, 0], rel=1e-13) == M
    assert pytest.approx(vessel.potential(q), rel=1e-12) == U
    assert dM == pytest.approx(vessel.mass_gradient(q)[0, 0, 0], rel=1e-11)
    assert dU == pytest.approx(vessel.gradient(q)[0], rel=1e-10)


def test_plain_floats_need_curves():
    with pytest.raises(InputError, match="model=curves"):
        HeaveEnergy(ship(2.0, fluid()))


def test_zero_pressure_takes_no_current():
    from dataclasses import replace

    still = ship(0.0, replace(curves(), free_surface="zero_pressure"))
    with pytest.raises(InputError, match="free_surface=zero_pressure: no current=1"):
        still.at_current(1.0)


@cache
def long_run():
    """A thousand linear periods of 13.7 s at 2 m/s in 70 steps each."""
    energy = HeaveEnergy(ship(2.0))
    track = trajectory(energy, -0.1, 0.0, 13.7 / 70, 70_000)
    assert track.outcome == "converged"
    kept = slice(None, None, 7)
    pairs = zip(track.position[kept].tolist(), track.momentum[kept].tolist(), strict=True)
    values = ((P, energy(w)) for w, P in pairs)
    return np.array([P**2 / 2 / M + U for P, (M, U, _, _) in values])


def test_energy_drifts_by_less_than_1e_12_of_the_weights_in_100_periods():
    levels = long_run()[:1001]
    assert np.abs(levels - levels[0]).max() < 1e-12 * WEIGHT


def test_energy_has_no_trend_over_1000_periods():
    """What is left is the rounding of U, some 1e-8 J/m a step, adding up as a random walk."""
    levels = long_run()
    walk = 4 * 1e-8 * np.sqrt(70_000)
    assert np.abs(levels - levels[0]).max() < walk
    assert walk < 1e-12 * WEIGHT


def test_full_model_and_curves_make_the_same_step():
    phases = []
    for model in (fluid(), curves()):
        phase = Phase(np.array([-0.1]), np.zeros(1))
        for _ in range(5):
            phase = advance(ship(2.0, model), phase, 0.2, np.ones(1)).phase
        phases.append(phase)
    assert phases[0].position == pytest.approx(phases[1].position, rel=1e-9)
    assert phases[0].momentum == pytest.approx(phases[1].momentum, rel=1e-8)
