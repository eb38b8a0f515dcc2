"""Several modes at once: gyroscopic force, Galilei, reciprocity, conservation over long runs."""

from functools import cache

import numpy as np
import pytest

from squat.channel import Channel
from squat.dynamics import Motion
from squat.dynamics.energy_momentum import Phase, advance
from squat.dynamics.hydrostatics import Hydrostatics
from squat.dynamics.lagrangian import energy
from squat.fluid.energy import ShipEnergy, still_water
from squat.fluid.potential import PotentialFluid
from squat.fluid.ship import about_another_point, about_gravity, rigid_body
from squat.mesh import subdivided, submesh
from squat.reduced import Training
from squat.reduced.box import BoxSize
from squat.reduced.greedy import reduce
from squat.water import Water
from tests.hulls import CHANNEL, NAMES, hull, zones

WATER = Water(density=1000.0, gravity=9.81)
MODES = ("surge", "heave", "pitch")
Q = np.array([0.3, -2.0, 0.03])


@cache
def fluid(name="rectangle", cuts=8, current=1.0, modes=MODES, channel=CHANNEL):
    coarse = submesh(hull(name), channel, modes)
    mesh = about_gravity(subdivided(coarse, cuts), hull(name))
    return PotentialFluid(mesh, WATER, "rigid_lid", current)


def ship(water, name="rectangle"):
    submesh = water.mesh.submesh
    body = rigid_body(hull(name), WATER, submesh.modes)
    return ShipEnergy(body, still_water(submesh, WATER), water, water.current)


def pressure_gyroscopic(water, q, velocity):
    """The part of the integrated pressure that is odd in q', over V, along the true flow."""
    h = 1e-4

    def force(v):
        ahead, behind = (water.flow(q + s * h * v, v).potential for s in (1, -1))
        return water.force(water.flow(q, v), (ahead - behind) / (2 * h))

    return (force(velocity) - force(-velocity)) / 2


@pytest.mark.parametrize("velocity", [(0.0, 0.2, 0.0), (0.2, 0.0, 0.0), (0.0, 0.0, 0.01)])
def test_gyroscopic_force_is_what_pressure_integration_finds(velocity):
    """No energy test sees it missing. At rounded corners P1 pressure converges with the mesh."""
    v, scale = np.array(velocity), np.array([1.0, 1.0, 0.05])  # m of lever: one size for all
    apart = []
    for cuts in (4, 12):
        water = fluid("rounded_box", cuts=cuts)
        expected = ship(water, "rounded_box").gyroscopic(Q) @ v
        apart.append(np.linalg.norm(scale * (pressure_gyroscopic(water, Q, v) - expected)))
    assert apart[1] < 0.6 * apart[0]
    assert apart[1] < 0.04 * np.linalg.norm(scale * expected)


@pytest.mark.parametrize("name", NAMES)
def test_gyroscopic_force_does_no_work(name):
    gam = ship(fluid(name, cuts=3), name).gyroscopic(Q)
    assert np.abs(gam).max() > 0
    assert np.array_equal(gam, -gam.T)


def test_heave_force_depends_on_the_current_less_the_surge_velocity():
    """Galilei: F1 (V - u)^2 in heave, so that Gam_12 = 2 V F1; but for the mesh and its ends."""
    long = Channel(depth=20.0, upstream=80.0, downstream=80.0)
    system = ship(fluid(cuts=8, channel=long))
    q = np.array([0.0, -1.0, 0.0])
    slope = system.model.slopes(q).a[1]
    F1 = (slope + WATER.density * 40) / 2
    assert system.gyroscopic(q)[1, 0] == pytest.approx(-2 * F1, rel=5e-3)
    still = system.water_force(Motion(q, np.zeros(3), np.zeros(3)))[1]
    speed = np.array([0.4, 0.0, 0.0])
    moving = system.water_force(Motion(q, speed, np.zeros(3)))[1]
    slower = system.at_current(0.6).water_force(Motion(q, np.zeros(3), np.zeros(3)))[1]
    assert moving == pytest.approx(slower, abs=1e-2 * abs(still - slower))


@pytest.mark.parametrize("name", NAMES)
def test_waters_inertia_is_reciprocal_and_positive(name):
    flows = fluid(name, cuts=3).unit_flows(Q)
    c = flows.loads @ flows.unit.T
    assert c == pytest.approx(c.T, abs=1e-10 * np.abs(c).max())
    assert np.linalg.eigvalsh(c).min() > 0


@pytest.mark.parametrize("name", NAMES)
def test_added_mass_about_another_point_is_that_of_a_mesh_turned_about_it(name):
    moved = np.array([3.0, -2.5])
    water = fluid(name, cuts=3)
    other = PotentialFluid(
        water.mesh.about(water.mesh.submesh.motion.center + moved), WATER, "rigid_lid", 1.0
    )
    rest = np.zeros(3)
    expected = about_another_point(water.coefficients(rest).c, moved)
    found = other.coefficients(rest).c
    assert found == pytest.approx(expected, rel=1e-9, abs=1e-9 * np.abs(found).max())


@pytest.mark.parametrize("name", NAMES)
def test_stiffness_of_still_water_is_the_second_derivative_of_its_energy(name):
    still = still_water(zones(name), WATER)
    h = np.array([1e-3, 1e-3, 1e-4])
    rows = [
        (still.gradient(h[k] * e) - still.gradient(-h[k] * e)) / (2 * h[k])
        for k, e in enumerate(np.eye(3))
    ]
    assert isinstance(still, Hydrostatics)
    assert np.array(rows) == pytest.approx(still.stiffness, rel=1e-5, abs=1e-3)


@pytest.fixture(scope="module")
def reduced():
    """Heave and pitch on a model that answers at once: as conservative as the full one."""
    coarse = submesh(hull("rectangle"), CHANNEL, ("heave", "pitch"))
    mesh = about_gravity(subdivided(coarse, 2), hull("rectangle"))
    box = BoxSize(clearance=0.3, pitch=0.15, points=8, pitch_points=5)
    made = reduce(mesh, 1000.0, "rigid_lid", Training(box=box, tolerance=1e-3, positions=3))
    body = rigid_body(hull("rectangle"), WATER, ("heave", "pitch"))
    return ShipEnergy(body, still_water(mesh.submesh, WATER), made.model, 1.5)


def test_energy_of_two_modes_is_kept_over_ten_periods(reduced):
    phase = Phase(np.array([-0.1, 0.005]), np.zeros(2))
    first, drift, pitch = reduced.potential(phase.position), 0.0, 0.0
    period = 2 * np.pi / np.sqrt(9.81e3 * 40 / reduced.mass(phase.position)[0, 0])
    for _ in range(10 * 12):
        step = advance(reduced, phase, period / 12, reduced.lengths)
        assert step.outcome == "converged"
        phase = step.phase
        velocity = np.linalg.solve(reduced.mass(phase.position), phase.momentum)
        drift = max(drift, abs(energy(reduced, phase.position, velocity) - first))
        pitch = max(pitch, abs(phase.position[1]))
    assert pitch >= 0.005
    assert drift < 1e-12 * reduced.body.mass * 9.81 * 10
