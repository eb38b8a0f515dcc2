"""Integrated pressure in reduced coordinates against the integral over the hull's edges."""

import numpy as np
import pytest

from squat.fluid.model import Flow
from squat.mesh.limits import GroundedError, LiftedError, PositionError
from squat.reduced.heave import HeaveFluid
from squat.reduced.hull import HullFluid

ROUNDING = 1e-11
"""Of the largest force: differences of potentials in a triangle lose some four of 16 digits."""
SERIES = 1e-9
"""Of the force: 48 terms of series that lose a factor of two with each, and their rounding."""
SHIPS = ["heave", "pitch", ("free_surface=blend",), ("hull=chamfered_box", "reduced.positions=4")]


@pytest.fixture
def ship(request, pair):
    if isinstance(request.param, str):
        return request.getfixturevalue(request.param)
    return pair("mesh=coarse", *request.param)


def states(ship, count=20):
    """Positions, velocities, and coordinates of any potential and rate, not those of a flow."""
    draw = np.random.default_rng(5)
    modes, size = len(ship.model.modes), sum(s.size for s in ship.model.systems)
    for q in ship.positions(count, seed=3):
        yield q, draw.normal(size=modes) * 0.3, *draw.normal(size=(2, size))


@pytest.mark.parametrize("ship", SHIPS, indirect=True)
def test_form_is_the_edge_integral_for_any_potential_and_rate(ship):
    edges = ship.loaded.fluid(ship.case.water, 2.0)
    fluid, basis = HullFluid.of(edges), np.vstack(edges.basis)
    for q, velocity, x, rate in states(ship):
        found = fluid.force(Flow(q, velocity, x), rate)
        exact = edges.force(Flow(q, velocity, x @ basis), rate @ basis)
        assert np.abs(found - exact).max() < ROUNDING * np.abs(exact).max()


@pytest.mark.parametrize("ship", SHIPS, indirect=True)
def test_form_is_the_edge_integral_of_the_flow_past_a_ship(ship):
    edges = ship.loaded.fluid(ship.case.water, 2.0)
    fluid = HullFluid.of(edges)
    for q in ship.positions(10):
        velocity = 0.1 * np.ones(len(q))
        mine, theirs = fluid.flow(q, velocity), edges.flow(q, velocity)
        found = fluid.force(mine, 0.3 * mine.potential)
        exact = edges.force(theirs, 0.3 * theirs.potential)
        assert np.abs(found - exact).max() < ROUNDING * np.abs(exact).max()


@pytest.mark.parametrize("keys", [(), ("free_surface=blend",)])
def test_tables_of_heave_are_the_edge_integral(keys, pair):
    ship = pair("mesh=coarse", *keys)
    edges = ship.loaded.fluid(ship.case.water, 2.0)
    fluid = HeaveFluid.of(edges)
    for q in ship.positions(30):
        for velocity in np.array([[0.0], [0.2], [-1.0]]):
            mine, theirs = fluid.flow(q, velocity), edges.flow(q, velocity)
            found = fluid.force(mine, 0.3 * mine.potential)
            exact = edges.force(theirs, 0.3 * theirs.potential)
            assert np.abs(found - exact).max() < SERIES * np.abs(exact).max()


def test_tables_refuse_what_the_model_refuses(heave, at):
    fluid = HeaveFluid.of(heave.loaded.fluid(heave.case.water, 2.0))
    with pytest.raises(GroundedError):
        fluid.flow(at(-9.95), at(0))
    with pytest.raises(LiftedError):
        fluid.flow(at(5.1), at(0))
    with pytest.raises(PositionError, match="finite"):
        fluid.flow(at(np.nan), at(0))
