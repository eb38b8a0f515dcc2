"""The moving submesh: orientation for every admissible position, limits by name, exact rates."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from squat.channel import Channel
from squat.errors import InputError
from squat.mesh import GroundedError, LiftedError, PositionError, subdivided, submesh
from squat.mesh.limits import CLEARANCE, PITCH, WALL
from squat.mesh.quality import quality
from tests.hulls import CHANNEL, NAMES, hull, zones

UNIT = st.floats(0, 1)
FINE = {name: subdivided(zones(name), 2) for name in NAMES}


def position(coarse, surge, height, pitch):
    """Admissible q from fractions: pitch first, then heave between grounded and lifted."""
    angle = (2 * pitch - 1) * PITCH
    moved = coarse.motion.positions(np.array([0, 0, angle]))[coarse.hull]
    limits = coarse.limits
    low = CLEARANCE * limits.clearance - moved[:, 1].min()
    high = min(limits.draft / 2, limits.level - WALL * limits.wall - moved[:, 1].max())
    return np.array([(surge - 0.5) * limits.reach, low + (high - low) * height, angle])


@pytest.mark.parametrize("name", NAMES)
@settings(max_examples=150, deadline=None, derandomize=True)
@given(surge=UNIT, height=UNIT, pitch=UNIT)
def test_fine_triangles_keep_their_orientation_for_every_admissible_position(
    name, surge, height, pitch
):
    coarse = zones(name)
    q = position(coarse, surge, height, pitch)
    fine = FINE[name]
    assert quality(fine.moved(q), fine.triangles).min() > 0


@pytest.mark.parametrize("name", NAMES)
def test_corners_of_the_admissible_range_keep_orientation(name):
    for surge in (0, 0.5, 1):
        for height in (0, 0.5, 1):
            for pitch in (0, 0.5, 1):
                q = position(zones(name), surge, height, pitch)
                assert zones(name).areas(zones(name).positions(q)).min() > 0


@pytest.mark.parametrize("name", NAMES)
def test_derivatives_of_the_motion_agree_with_finite_differences(name):
    motion = zones(name).motion
    q, h = np.array([0.3, -0.5, 0.02]), 1e-5
    for k, e in enumerate(h * np.eye(3)):
        first = (motion.positions(q + e) - motion.positions(q - e)) / (2 * h)
        second = (motion.first(q + e) - motion.first(q - e)) / (2 * h)
        # central differences: h^2 times third derivatives of some 20 m, and rounding 1e-15 40 m/h
        assert np.abs(first - motion.first(q)[k]).max() < 1e-8
        assert np.abs(second - motion.second(q)[k]).max() < 1e-8


@pytest.mark.parametrize("name", NAMES)
def test_the_channel_stands_still_and_water_line_points_slide_along_it(name):
    coarse = zones(name)
    q = position(coarse, 0.7, 0.4, 0.8)
    moved = coarse.positions(q)
    for boundary in ("In", "Out"):
        ends = np.unique(coarse.boundary[boundary])
        assert np.array_equal(moved[ends], coarse.rest[ends])
    assert np.all(moved[np.unique(coarse.boundary["FreeS"]), 1] == CHANNEL.depth)
    assert np.all(moved[np.unique(coarse.boundary["Botm"]), 1] == 0)


@pytest.mark.parametrize("name", NAMES)
def test_hull_moves_rigidly_and_its_walls_turn_with_it(name):
    coarse = zones(name)
    moved = coarse.positions(position(coarse, 0.2, 0.6, 0.9))
    ship = coarse.boundary["Ship"]
    wall = (coarse.rest[ship[:, 0], 0] == coarse.rest[ship[:, 1], 0]) & ~np.isin(
        ship, coarse.hull
    ).all(axis=1)

    def lengths(points):
        return np.linalg.norm(points[ship[:, 1]] - points[ship[:, 0]], axis=1)[~wall]

    assert lengths(moved) == pytest.approx(lengths(coarse.rest), rel=1e-12)
    sides = moved[ship[wall, 1]] - moved[ship[wall, 0]]
    slope = sides[:, 0] / sides[:, 1]
    assert slope == pytest.approx(np.full(2, -np.tan(0.8 * PITCH)), rel=1e-9)


def test_grounded_and_lifted_positions_are_refused_by_name():
    box, vee = zones("rectangle"), zones("v")
    box.check(np.array([0, -9.8, 0]))
    with pytest.raises(GroundedError, match="grounded"):
        box.check(np.array([0, -9.81, 0]))
    with pytest.raises(GroundedError, match="grounded"):
        box.check(np.array([0, -9.0, PITCH]))
    with pytest.raises(LiftedError, match=r"at most draft/2=5"):
        box.check(np.array([0, 5.1, 0]))
    with pytest.raises(LiftedError, match="lifts the hull's vertical sides"):
        vee.check(np.array([0, 0.95, 0]))
    with pytest.raises(PositionError, match=r"pitch=0.3: must be within"):
        box.check(np.array([0, 0, 0.3]))
    with pytest.raises(PositionError, match="surge=39"):
        box.check(np.array([39.0, 0, 0]))
    with pytest.raises(PositionError, match="must be finite"):
        box.check(np.array([0, np.nan, 0]))


def test_modes_are_a_subset_in_fixed_order():
    box = hull("rectangle")
    heave = submesh(box, CHANNEL, ("heave",))
    assert heave.full(np.array([-1.0])).tolist() == [0, -1, 0]
    assert heave.first(np.array([-1.0])).shape == (1, len(heave.rest), 2)
    with pytest.raises(InputError, match="modes"):
        submesh(box, CHANNEL, ("pitch", "heave"))


@pytest.mark.parametrize(
    "bottom",
    [
        ((-30.0, 0.0), (-29.0, 3.0)),
        ((15.0, 0.0), (17.0, 2.0)),
        ((-40.0, 0.0), (100.0, 6.0)),
        ((70.0, 5.0), (90.0, 0.0)),
    ],
)
def test_steps_and_slopes_of_the_bottom_carry_the_submesh(bottom):
    channel = Channel(depth=20.0, upstream=40.0, downstream=60.0, bottom=bottom)
    for name in NAMES:
        coarse = submesh(hull(name), channel)
        for q in ([0, 0, 0], [0.2, -2, 0.01], [-0.2, -4, 0.0], [0, -1, -0.02]):
            assert coarse.areas(coarse.positions(np.array(q, float))).min() > 0


@pytest.mark.parametrize(
    "bottom",
    [((48.5, 3.0), (51.5, 0.0)), ((44.25, 3.0), (45.75, 0.0)), ((-11.5, 0.0), (-8.5, 3.0))],
)
def test_a_shelf_hides_the_bottom_behind_it_from_the_keel_and_still_is_meshed(bottom):
    channel = replace(CHANNEL, bottom=bottom)
    for name in NAMES:
        coarse = submesh(hull(name), channel)
        for q in ([0, 0, 0], [0.1, -0.5, 0.005], [-0.1, 0.5, -0.005]):
            assert coarse.areas(coarse.positions(np.array(q, float))).min() > 0


@pytest.mark.parametrize("x", [0.0, 40.0])
def test_a_corner_of_the_bottom_below_an_end_of_the_keel_stays_where_it_is(x):
    channel = replace(CHANNEL, bottom=((x - 5.0, 3.0), (x, 0.0)))
    coarse = submesh(hull("rectangle"), channel)
    water = [
        coarse.areas(coarse.motion.positions(np.array(q))).sum()
        for q in ([0.0, 0.0, 0.0], [0.3, 0.0, 0.0])
    ]
    # Surge neither lifts the hull nor changes the channel: the water keeps its area.
    assert water[1] == pytest.approx(water[0], rel=1e-13)


def test_one_triangle_may_not_straddle_two_zones_and_the_area_is_whole():
    for name in NAMES:
        fine = FINE[name]
        assert fine.straddling() == 0
        a, b, c = (fine.points[i] for i in fine.triangles.T)
        total = ((b - a)[:, 0] * (c - a)[:, 1] - (b - a)[:, 1] * (c - a)[:, 0]).sum() / 2
        channel = (CHANNEL.upstream + hull(name).length + CHANNEL.downstream) * CHANNEL.depth
        assert total == pytest.approx(channel - hull(name).outline.area, rel=1e-12)


FEATURES = {"chamfered_box": "chamfer", "rounded_box": "radius"}
FULLNESS = {"lewis": ("hull.area_coefficient=0.85",)}  # that forms of all proportions can have


@pytest.mark.parametrize("length", [8.0, 20.0, 100.0])
@pytest.mark.parametrize("draft", [2.0, 5.0, 12.0])
@pytest.mark.parametrize("name", NAMES[1:])
def test_other_proportions_keep_their_orientation_too(name, draft, length):
    size = f"{FEATURES.get(name, 'wall')}={min(draft, length / 2) / 5}"
    keys = f"hull.length={length}", f"hull.draft={draft}", f"hull.{size}", *FULLNESS.get(name, ())
    coarse = submesh(hull(name, *keys), Channel(depth=20.0, upstream=40.0, downstream=30.0))
    random = np.random.default_rng(20)
    for fractions in random.uniform(0, 1, (40, 3)):
        q = position(coarse, *fractions)
        try:
            vertices = coarse.positions(q)
        except GroundedError:  # long hulls cannot pitch by five degrees at any heave
            continue
        assert coarse.areas(vertices).min() > 0
