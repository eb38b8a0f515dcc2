"""Limits in heave and pitch: what must be so on any mesh."""

import numpy as np
import pytest
from scipy.linalg import expm
from scipy.ndimage import label
from scipy.optimize import root

from squat.config import compose, validate
from squat.dynamics.energy_momentum import Phase, advance
from squat.trim import run as trim
from squat.trim.barrier import Barrier
from squat.trim.equilibria import Modes, branch, fold
from squat.trim.release import release

SMALL = (
    "mesh.near=2", "mesh.far=6", "reduced.positions=8", "reduced.tolerance=1e-2",
    "reduced.box.clearance=0.2", "reduced.box.points=8", "reduced.box.pitch_points=5",
)  # fmt: skip


@pytest.fixture(scope="module")
def vessel():
    case = validate(compose("trim", *SMALL)).case
    ship, mesh = trim._ship(case, case.hull)
    return ship, trim._region(case, mesh)


def test_branch_solves_the_equilibrium_and_its_fold_is_where_the_current_is_greatest(vessel):
    ship, _ = vessel
    modes = Modes(ship.at_current, ship.lengths)
    points = branch(modes, np.zeros(2), 0.0, np.array([0.0, 0.0, 1.0]), 0.4, 14)
    for point in points:
        force = ship.at_current(point.current).gradient(point.position)
        assert np.abs(force[0]) < 1e-6 * ship.body.mass
    best = max(points, key=lambda point: point.current)
    limit = fold(modes, best)
    assert limit.current >= best.current
    U2 = modes.jacobian(limit.position * modes.lengths, limit.current**2 / 2)[:, :-1]
    values = np.linalg.eigvalsh(U2)
    assert np.abs(values).min() < 1e-6 * np.abs(modes.jacobian(np.zeros(2), 0.0)[0, 0])
    assert points[0].unstable == 0
    assert points[-1].unstable >= 1


def test_what_energy_calls_safe_is_not_lost_and_pitch_never_helps(vessel):
    ship, region = vessel
    modes = Modes(ship.at_current, ship.lengths)
    start = np.array([-0.1, 0.002])
    points = branch(modes, np.zeros(2), 0.0, np.array([0.0, 0.0, 1.0]), 0.4, 12)
    limit = fold(modes, max(points, key=lambda point: point.current))
    barrier = Barrier(ship.at_current, region, start)
    safe = barrier.safe_speed(limit.current)
    alone = trim._heave_alone(ship, region, start, limit.current)
    assert 0 < safe <= alone <= limit.current
    way = barrier.lowest(safe)
    assert way.potential == pytest.approx(ship.at_current(safe).potential(start), rel=1e-4)
    track = release(ship.at_current(0.99 * safe), region, start, ship.lengths, 0.3, 60)
    assert not track.lost
    assert track.drift < 1e-12 * ship.body.mass * 9.81 * 10


def test_the_lowest_pass_out_of_the_well_is_a_saddle_that_no_path_on_a_finer_grid_undercuts(vessel):
    ship, region = vessel
    barrier, V = Barrier(ship.at_current, region, np.array([-0.1, 0.002])), 2.3
    way, system = barrier.lowest(V), ship.at_current(V)
    q = np.array([way.heave, way.pitch])
    assert np.abs(system.gradient(q)[0]) < 1e-6 * ship.body.mass * 9.81
    level = way.potential - 0.1 * barrier.margin(V)
    trims = np.linspace(-region.pitch, region.pitch, 31)
    share = np.linspace(0, 1, 60)
    sea = np.array([
        [system.potential(np.array([low + s * (region.high(t) - low), t])) <= level for s in share]
        for t in trims.tolist()
        for low in [region.low(t)]
    ])  # fmt: skip
    pools, count = label(sea)
    exits = {*pools[:, 0], *pools[0], *pools[-1]} - {0}
    middle = sea.shape[0] // 2
    wells = set(pools[middle]) - {0} - exits
    assert count >= 2
    assert len(wells) == 1


def test_a_stretched_hull_displaces_what_was_asked_for():
    case = validate(compose("trim", "hull=half_ellipse", "displacement=400")).case
    hull = trim.stretched(case)
    assert hull.outline.area == pytest.approx(400, rel=1e-9)
    assert hull.draft == case.hull.draft


def test_the_trimmed_branch_leaves_the_level_one_at_its_fold(vessel):
    ship, region = vessel
    modes = Modes(ship.at_current, ship.lengths)
    barrier = Barrier(ship.at_current, region, np.array([-0.1, 0.002]))
    safe = barrier.safe_speed(2.6)
    way = barrier.lowest(safe)
    x = np.array([way.heave, way.pitch]) * ship.lengths
    points = branch(modes, x, safe**2 / 2, np.array([0.0, 0.0, 1.0]), 0.3, 14)
    pitch = np.array([point.position[1] for point in points])
    assert pitch[0] * pitch[-1] < 0
    level = points[int(np.abs(pitch).argmin())]
    limit = fold(modes, level)
    # A parabola in pitch: the nearest point is at most half a step of arc, 0.15 m, off the fork.
    assert level.current == pytest.approx(limit.current, rel=1e-2)
    assert all(point.unstable >= 1 for point in points)


def test_small_motion_in_a_current_is_that_of_the_linear_system_gam_included(vessel):
    ship, _ = vessel
    system, lengths = ship.at_current(2.0), ship.lengths
    rest = root(lambda q: system.gradient(q) / 1e5, np.array([-1.07, 0.0]), tol=1e-12).x
    h = 1e-4 / lengths
    columns = [
        (system.gradient(rest + e) - system.gradient(rest - e)) / (2 * e.sum()) for e in np.diag(h)
    ]
    stiffness, mass = np.array(columns).T, system.mass(rest)
    gyroscopic = system.gyroscopic(rest)
    dt, steps, first = 0.2, 60, 1e-4 * np.array([1.0, 0.0])

    def linear(gam):
        zero, one = np.zeros((2, 2)), np.eye(2)
        solved = np.linalg.solve(mass, np.hstack([-stiffness, gam]))
        rate = np.vstack([np.hstack([zero, one]), solved])
        return lengths * (expm(dt * steps * rate) @ np.append(first, [0, 0]))[:2]

    phase = Phase(rest + first, np.zeros(2))
    for _ in range(steps):
        phase = advance(system, phase, dt, lengths).phase
    moved = lengths * (phase.position - rest)
    # The step is of second order: omega dt = 0.1 leaves a phase error of some 1e-3 per radian.
    tolerance = 1e-2 * np.linalg.norm(first)
    assert np.abs(moved - linear(gyroscopic)).max() < tolerance
    assert np.abs(moved - linear(0 * gyroscopic)).max() > 3 * tolerance
