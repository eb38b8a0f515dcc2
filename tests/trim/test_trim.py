"""Limits in heave and pitch: what must be so on any mesh."""

import re
from dataclasses import replace

import numpy as np
import pytest
from scipy.linalg import expm
from scipy.ndimage import label
from scipy.optimize import root

from squat.config import compose, validate
from squat.dynamics.energy_momentum import Phase, advance
from squat.errors import InputError
from squat.figures.trim import _with_fold
from squat.figures.trim import trim as draw
from squat.mesh import PositionError
from squat.stability.sampled import Sampled
from squat.trim import run as trim
from squat.trim.barrier import Barrier, _well
from squat.trim.case import Companions
from squat.trim.equilibria import Modes, branch, fold
from squat.trim.release import lost_speed, release
from squat.trim.summary import summary

SMALL = (
    "mesh.near=2", "mesh.far=6", "reduced.positions=8", "reduced.tolerance=1e-2",
    "reduced.box.clearance=0.2", "reduced.box.points=8", "reduced.box.pitch_points=5",
)  # fmt: skip


@pytest.fixture(scope="module")
def vessel():
    case = validate(compose("trim", *SMALL)).case
    ship, mesh = trim._ship(case, case.hull, case.mesh)
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
    values, vectors = np.linalg.eigh(U2)
    weakest = np.abs(values).argmin()
    assert np.abs(values[weakest]) < 1e-6 * np.abs(modes.jacobian(np.zeros(2), 0.0)[0, 0])
    # Heave gives way there, not pitch: that is the fork close by, where the trimmed branch leaves.
    assert np.abs(vectors[0, weakest]) > 0.9
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
    # Over a shelf the fold of a ship that trims is lower, and bounds nothing of one that is level.
    assert trim._heave_alone(ship, region, start, 0.5 * alone) == pytest.approx(alone, rel=1e-9)
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


def test_a_fold_far_from_the_branch_is_refused(vessel):
    ship, _ = vessel
    modes = Modes(ship.at_current, ship.lengths)
    points = branch(modes, np.zeros(2), 0.0, np.array([0.0, 0.0, 1.0]), 0.4, 14)
    case = validate(compose("trim", *SMALL)).case
    assert trim._fold(replace(case, arc=0.04), modes, points).current > 2.5
    with pytest.raises(InputError, match=r"arc=0\.0001: no fold near .*; give less"):
        trim._fold(replace(case, arc=1e-4), modes, points)


def test_a_bracket_within_the_tolerance_is_not_halved(vessel):
    ship, region = vessel
    start, grid = np.array([-0.1, 0.002]), (0.3, 40)
    lost, kept = lost_speed(
        ship.at_current, region, start, ship.lengths, grid, (2.0, 2.65), tolerance=1.0
    )
    assert lost == pytest.approx((2.0 + 2.65) / 2)
    assert not kept.lost


@pytest.fixture(scope="module")
def recorded():
    return trim.run(validate(compose("trim", "cases/trim@_global_=small", "points=30")).case)


def test_errors_cover_the_limits_of_extrapolated_p2_meshes(recorded):
    """The level ship's fold and its limit in heave alone are known to 1e-4 without pitch.

    The trim of the start, 0.001 rad, changes the latter by the order of its square.
    """
    case = validate(compose("limits", "accuracy=study")).case
    found = Sampled(case.ship, case.accuracy).limits(-0.1, 0.0)
    for name, exact in (
        ("squat_speed", found.limit_2d),
        ("heave_only_limit", found.limit_dynamic),
    ):
        error = float(recorded[f"{name}_error"])
        assert abs(float(recorded[name]) - exact) < error < 0.02 * exact
    assert 0 < float(recorded["safe_speed_error"]) < 0.02 * float(recorded["safe_speed"])


@pytest.mark.parametrize(
    ("variable", "name"),
    [
        ("squat_speed", "fold"),
        ("safe_speed", "safe speed"),
        ("dynamic_limit", "lost in the run"),
        ("heave_only_limit", "heave alone"),
    ],
)
def test_each_limit_is_told_with_its_error(recorded, variable, name):
    found = re.search(rf"  {name} +(\S+) \+- (\S+) m/s: ", recorded.attrs["summary"])
    error = float(recorded[f"{variable}_error"])
    assert float(found[1]) == pytest.approx(float(recorded[variable]), abs=error)
    assert float(found[2]) == pytest.approx(error, rel=0.1)


def test_a_start_with_trim_is_told_apart_from_the_level_one_of_task_limits(recorded):
    case = validate(compose("trim")).case
    said = summary(case, recorded)
    assert "w(0) = -0.1 m with a pitch of 0.001 rad, +0.02 m down at the bow" in said
    assert "pitch locked at 0.001 rad" in said
    assert "task=limits locks it at zero" in said
    level = validate(compose("trim", "start.pitch=0")).case
    assert "locks it at zero" not in summary(level, recorded)


def test_the_picture_tells_the_errors(recorded):
    legend = draw(recorded).legends[0]
    assert sum("±" in text.get_text() for text in legend.get_texts()) == 4
    without = draw(recorded.assign(safe_speed_error=np.nan)).legends[0]
    assert sum("±" in text.get_text() for text in without.get_texts()) == 3


def test_the_error_is_the_safety_times_that_of_values_of_one_order_and_none_without_values():
    companions = Companions(refinement=2.0, safety=1.25)
    h = np.array([4.0, 2.0, 1.0])
    values = 3 + 0.01 * np.column_stack([h**2, h**1.5, -(h**3)])
    assert companions.error(values) == pytest.approx(1.25 * 0.01 * np.ones(3), rel=1e-6)
    lost = np.array([[np.nan], [3.04], [3.01]])  # first order is then assumed
    assert companions.error(lost) == pytest.approx([1.25 * 0.03], rel=1e-6)
    assert np.isnan(companions.error(np.array([[3.1], [np.nan], [3.01]])))


def test_a_mesh_too_coarse_for_a_fold_leaves_no_error(monkeypatch):
    case = validate(compose("trim", *SMALL)).case

    def beyond(*_):
        raise PositionError("pitch=1: beyond the reduced model's 0.2 rad")

    monkeypatch.setattr(trim, "fold", beyond)
    assert np.isnan(trim._on(case, case.hull, case.mesh)).all()


def test_a_hull_that_falls_in_a_stream_is_turned_down_at_its_downstream_end(vessel):
    """The moment of Gam."""
    ship, region = vessel
    low = np.array([-1.0, 0.0])
    assert (ship.at_current(2.36).gyroscopic(low) @ np.array([-0.1, 0.0]))[1] < 0
    kept = release(ship.at_current(1.0), region, np.array([-0.1, 0.0]), ship.lengths, 0.3, 60)
    falling = kept.position[: kept.position[:, 0].argmin(), 1]
    assert abs(falling.min()) > 2 * abs(falling.max())


@pytest.mark.parametrize("first", [-0.005, 0.0, 0.005])
def test_it_grounds_stern_down_whichever_way_its_first_trim_points(vessel, first):
    ship, region = vessel
    start = np.array([-0.1, first])
    lost = release(ship.at_current(2.36), region, start, ship.lengths, 0.3, 200)
    assert lost.lost
    assert lost.position[-1, 1] < -0.1


def test_a_long_hull_over_a_small_gap_is_asked_for_no_more_pitch_than_it_can_take(caplog):
    """Half its length times the box's pitch is three times the gap."""
    keys = "hull.length=120", "hull.draft=8", "channel.depth=12", "cases/trim@_global_=small"
    case = validate(compose("trim", *keys)).case
    with caplog.at_level("DEBUG"):
        data = trim.run(case)
    (line,) = [one for one in caplog.records if "reduced.box.pitch=0.2" in one.getMessage()]
    assert line.levelname == "DEBUG"  # the key may not be the user's
    bounded = trim._within_reach(case, case.hull).reduced.box.pitch
    ends = (12 - 8 + 8) / case.hull.length  # both ends at once: at the bottom, out of the water
    assert 0.5 * ends < bounded < ends
    assert 0 < float(data["safe_speed"]) < float(data["squat_speed"])
    assert float(data["safe_speed"]) <= float(data["heave_only_limit"])
    # Long and shallow: where the 1D theory holds, to the share of the ends.
    assert float(data["squat_speed"]) == pytest.approx(float(data["squat_speed_1d"]), rel=4 / 60)


def test_a_hull_with_room_keeps_the_box_that_it_is_given(vessel):
    case = validate(compose("trim", *SMALL)).case
    assert trim._within_reach(case, case.hull) == case


def test_the_well_is_where_descent_from_the_start_ends():
    U = np.array([[0.0, 1.0, 2.0, 3.0], [5.0, 4.0, 3.0, 2.5], [6.0, 7.0, 8.0, 2.0]])
    assert _well(U, (2, 0)) == (0, 0)
    assert _well(U, (2, 3)) == (2, 3)


def test_the_picture_calls_stable_what_the_dataset_counts_as_such(recorded):
    """Of both branches; a hull that trims from rest has stable equilibria on either."""
    turned = recorded.assign(
        unstable=("point", np.arange(recorded.sizes["point"]) // 4 % 3),
        trimmed_unstable=("trimmed_point", np.arange(recorded.sizes["trimmed_point"]) % 2),
    )
    for axes, name in zip(draw(turned).axes, ("heave", "pitch"), strict=True):
        unit = {"heave": 1.0, "pitch": 180 / np.pi}[name]
        solid = [line for line in axes.lines if line.get_linestyle() == "-" and len(_x(line)) > 2]
        rest = np.concatenate([line.get_ydata() for line in solid if line.get_linewidth() < 4])
        stable = unit * turned[name].values[turned["unstable"].values == 0]
        assert set(stable) <= set(rest)
        assert not set(unit * turned[name].values) <= set(rest)
    labels = [text.get_text() for text in draw(turned).legends[0].get_texts()]
    assert len(labels) == len(set(labels))
    assert {"from rest, stable", "through the lowest pass, stable"} <= set(labels)
    assert not any("level" in label or "trimmed" in label for label in labels)


def test_a_branch_is_stable_up_to_its_fold():
    speed = np.array([0.0, 1.0, 1.2, 1.1, 0.9])
    assert list(_with_fold(np.array([0, 0, 1, 1, 1]), speed)) == [0, 0, 0, 1, 1]
    assert list(_with_fold(np.array([1, 1, 1]), speed[2:])) == [1, 1, 1]


def test_an_older_file_that_counts_nothing_on_the_second_branch_claims_nothing(recorded):
    legend = draw(recorded.drop_vars("trimmed_unstable")).legends[0]
    labels = [text.get_text() for text in legend.get_texts()]
    assert [label for label in labels if "lowest pass," in label] == [
        "through the lowest pass, stability not recorded"
    ]


def _x(line):
    return line.get_xdata()
