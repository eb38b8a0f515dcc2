"""The ship of section 3.6 in heave: the same limits by independent ways."""

from itertools import pairwise

import numpy as np
import pytest
from numpy.polynomial import Chebyshev
from scipy.integrate import solve_ivp

from squat.dynamics import RigidBody
from squat.dynamics.hydrostatics import Hydrostatics
from squat.fluid.direct import DirectEnergies
from squat.fluid.energy import ShipEnergy
from squat.fluid.matching import RectangleReference
from squat.fluid.potential import PotentialFluid
from squat.mesh import submesh
from squat.mesh.generate import generate
from squat.stability.branches import equilibria
from squat.stability.dynamic import dynamic_squat_speed
from squat.stability.equilibria import OneDimensionalModel
from squat.stability.fold import squat_speed
from squat.stability.heave import HeaveSystem
from squat.stability.one_mode import Along
from squat.stability.orbits import orbit
from squat.stability.sampling import Ship, estimate


@pytest.fixture(scope="module")
def given(case):
    return case("added_mass", "mesh=coarse", "accuracy.near=0.16")


@pytest.fixture(scope="module")
def ship(given):
    return Ship(given.hull, given.channel, given.water, "rigid_lid", 0.02)


@pytest.fixture(scope="module")
def levels(given, ship):
    return ship.levels(given.accuracy)


@pytest.fixture(scope="module")
def coarse(given, ship):
    return ship.on(given.mesh)


@pytest.fixture(scope="module")
def exact_stream():
    """a/rho by eigenfunction matching, between w = -4.2 and w = -2.4 (no mesh)."""
    ends = np.log([10 - 4.2, 10 - 2.4])
    nodes = np.cos(np.pi * (np.arange(8) + 0.5) / 8)
    gaps = np.exp(ends.mean() + np.diff(ends)[0] / 2 * nodes)
    geometry = {"upstream": 40.0, "downstream": 60.0, "free_surface": "rigid_lid"}
    cases = [RectangleReference(40.0, 20 - gap, 20.0, **geometry, terms=8000) for gap in gaps]
    return Chebyshev.fit(np.log(gaps), [one.current({})[0] for one in cases], 7, domain=ends)


def test_squat_speed_is_that_of_eigenfunction_matching(given, levels, exact_stream):
    """At an equilibrium V^2 = 2 g L w/(a'/rho + L); the fold is its greatest value."""
    w = np.linspace(-4, -2.6, 20_001)
    slope = exact_stream.deriv()(np.log(10 + w)) / (10 + w)
    exact = np.sqrt((2 * 9.81 * 40 * w / (slope + 40)).max())
    folds = [squat_speed(level.at_current) for level in levels]
    assert all(fold.width <= 1e-8 for fold in folds)
    found = estimate([fold.speed for fold in folds], given.accuracy)
    assert found.error < 1e-4
    assert abs(found.value - exact) < found.error
    assert all(before.speed > after.speed > exact for before, after in pairwise(folds))


def test_limits_converge_like_the_energy(given, levels):
    """P2 on a mesh graded to the corners: order 4 or nearly so; the errors shrink eightfold."""
    folds = [squat_speed(level.at_current) for level in levels]
    speeds = [
        dynamic_squat_speed(level.at_current, fold, -0.1, 0.0)
        for level, fold in zip(levels, folds, strict=True)
    ]
    for values in (speeds, [fold.speed for fold in folds]):
        changes = -np.diff(values)
        assert changes[1] > 0
        assert changes[0] > 8 * changes[1]


def test_uniform_p1_meshes_converge_at_the_corners_rate(given, ship, levels):
    """h^(4/3), from above: elements underestimate the suction."""
    best = squat_speed(levels[-1].at_current).speed
    errors = []
    for h in (2.0, 1.0, 0.5):
        size = type(given.mesh)(near=h, far=h, slope=0.35, grading=0.0, corner_radius=5.0, order=1)
        errors.append(squat_speed(ship.on(size).at_current).speed - best)
    rates = np.log2(np.array(errors[:-1]) / errors[1:])
    assert rates == pytest.approx([4 / 3, 4 / 3], abs=0.2)


def test_dynamic_limit_lies_below_the_fold_and_the_1d_speed_above(given, coarse):
    fold = squat_speed(coarse.at_current)
    dynamic = dynamic_squat_speed(coarse.at_current, fold, -0.1, 0.0)
    one = OneDimensionalModel(given.hull, given.channel, given.water).squat_speed()
    assert dynamic < fold.speed < one.speed
    pushed = dynamic_squat_speed(coarse.at_current, fold, -0.1, 0.3)
    assert pushed < dynamic


def test_heave_system_is_the_ships_energy(given, coarse):
    """The elementwise system and `ShipEnergy` over the mesh itself: one physics, two codes."""
    mesh = generate(submesh(given.hull, given.channel, ("heave",)), given.mesh)
    outline, H = given.hull.outline, given.channel.depth
    body = RigidBody(("heave",), given.water.density * outline.area, 0.0, given.water.gravity)
    up = np.array([0, H])
    chain, center = outline.vertices + up, outline.center + up
    still = Hydrostatics(given.water, chain, center, H, ("heave",))
    full = ShipEnergy(body, still, PotentialFluid(mesh, given.water, "rigid_lid", 2.0), 2.0)
    reference = Along(full, coarse.interval)
    fast = coarse.at_current(2.0)
    w = np.array([-9.2, -6.0, -1.0, 0.0, 3.0])
    assert fast.mass(w) == pytest.approx(reference.mass(w), rel=1e-8)
    assert fast.slope(w) == pytest.approx(reference.slope(w), rel=1e-6)
    assert fast.potential(w) == pytest.approx(reference.potential(w), rel=1e-8)


def test_direct_energies_are_those_of_the_coupled_run(given):
    mesh = generate(submesh(given.hull, given.channel, ("heave",)), given.mesh)
    for surface in ("rigid_lid", "blend"):
        direct = DirectEnergies(mesh, given.water, surface)
        run = PotentialFluid(mesh, given.water, surface, 1.0)
        for w in (-8.0, 0.0):
            q = np.array([w])
            for one, other in zip(direct.coefficients(q), run.coefficients(q), strict=True):
                assert one == pytest.approx(other, rel=1e-9)
            for one, other in zip(direct.slopes(q), run.slopes(q), strict=True):
                assert one == pytest.approx(other, rel=1e-8, abs=1e-6)


@pytest.mark.parametrize(("current", "velocity"), [(0.0, 0.0), (1.0, 0.0), (2.25, 0.3), (2.4, 0.0)])
def test_period_and_extremes_are_those_of_integration_in_time(coarse, current, velocity):
    mode = coarse.at_current(current)
    found = orbit(mode, -0.1, velocity)

    def rate(t, y):
        h = 1e-5
        bend = (mode.mass(y[0] + h) - mode.mass(y[0] - h)) / (2 * h)
        return [y[1], -(mode.slope(y[0]) + bend * y[1] ** 2 / 2) / mode.mass(y[0])]

    def turns(t, y):
        return y[1]

    start = [-0.1, velocity]
    done = solve_ivp(
        rate, (0, 2.2 * found.period), start, events=turns, rtol=1e-10, atol=1e-12, method="DOP853"
    )
    times, places = done.t_events[0], done.y_events[0][:, 0]
    times, places = times[times > 1e-3], places[times > 1e-3]
    assert times[2] - times[0] == pytest.approx(found.period, rel=1e-7)
    assert sorted(places[:2]) == pytest.approx([found.low, found.high], abs=1e-7)


@pytest.mark.parametrize("share", [0.998, 1.002])
def test_integration_in_time_turns_below_the_dynamic_limit_and_grounds_above(coarse, share):
    fold = squat_speed(coarse.at_current)
    mode = coarse.at_current(share * dynamic_squat_speed(coarse.at_current, fold, -0.1, 0.0))

    def rate(t, y):
        h = 1e-5
        bend = (mode.mass(y[0] + h) - mode.mass(y[0] - h)) / (2 * h)
        return [y[1], -(mode.slope(y[0]) + bend * y[1] ** 2 / 2) / mode.mass(y[0])]

    def grounds(t, y):
        return y[0] - mode.interval.low - 0.01

    def turns(t, y):
        return y[1] - 1e-6

    grounds.terminal = turns.terminal = True
    turns.direction = 1
    done = solve_ivp(rate, (0, 300), [-0.1, -1e-9], events=[turns, grounds], rtol=1e-9, atol=1e-11)
    assert bool(done.t_events[1].size) is (share > 1)
    assert bool(done.t_events[0].size) is (share < 1)


def test_curves_of_a_sloping_hull_give_equilibria_too(case):
    one = case("added_mass", "mesh=coarse", "hull=half_ellipse")
    ship = Ship(one.hull, one.channel, one.water, "rigid_lid", 0.02).on(one.mesh)
    assert isinstance(ship, HeaveSystem)
    fold = squat_speed(ship.at_current)
    assert len(equilibria(ship.at_current(0.9 * fold.speed))) == 2


def test_a_ship_floats_in_still_water_until_a_current_is_named(coarse):
    assert coarse.current == 0
    assert coarse.at_current(2.0).current == 2
    assert float(coarse.slope(0.0)) == 0
