"""Hull sections: areas against closed forms, one config line, impossible ones refused by name."""

import math

import numpy as np
import pytest
from pydantic import TypeAdapter, ValidationError
from shapely.geometry import LinearRing, Point

from squat.channel import (
    AnyHull,
    Channel,
    Curve,
    HalfEllipse,
    Lewis,
    Polygon,
    Rectangle,
    check_afloat,
    stretched,
)
from squat.config import compose, validate
from squat.errors import InputError
from tests.hulls import CHANNEL, NAMES, hull

BOX = ((0.0, 0.0), (0.0, -1.0), (4.0, -1.0), (4.0, 0.0))


@pytest.mark.parametrize("name", NAMES)
def test_any_hull_is_one_config_line_with_its_length_and_draft(name):
    outline = hull(name, "hull.length=30.0", "hull.draft=6.0").outline
    assert outline.length == pytest.approx(30, rel=1e-12)
    assert outline.draft == pytest.approx(
        6, rel=1e-3
    )  # chords of a curve may miss its lowest point
    assert outline.wall_height > 0
    validate(compose("equilibria", f"hull={name}"))


@pytest.mark.parametrize(
    ("name", "area", "tolerance"),
    [
        ("rectangle", 400, 1e-14),
        ("v", 40 + 9 * 40 / 2, 1e-14),
        ("chamfered_box", 400 - 4, 1e-14),
        ("rounded_box", 400 - 2 * (1 - math.pi / 4) * 9, 1e-5),
        ("half_ellipse", 40 + math.pi / 4 * 40 * 9, 5e-5),
        ("lewis", 40 + 0.9 * 40 * 9, 2e-4),
    ],
)
def test_area_agrees_with_the_closed_form_but_for_the_chords(name, area, tolerance):
    assert hull(name).outline.area == pytest.approx(area, rel=tolerance)


def lewis(length, draft, coefficient, segments=400):
    return Lewis(
        length=length, draft=draft, wall=1.0, area_coefficient=coefficient, segments=segments
    )


@pytest.mark.parametrize(
    ("length", "draft"), [(140.0, 8.0), (40.0, 10.0), (18.0, 10.0), (8.0, 9.0)]
)
@pytest.mark.parametrize("part", [1e-6, 0.5, 1 - 1e-6])
def test_a_lewis_form_stays_within_its_box_and_turns_nowhere_back(length, draft, part):
    least, greatest = lewis(length, draft, 0.7).fullness
    coefficient = least + part * (greatest - least)
    x, z = lewis(length, draft, coefficient).outline.vertices.T
    keel = z.argmin()
    assert z[keel] == pytest.approx(-draft, rel=1e-12)
    lowest = np.isclose(z, z.min(), rtol=1e-12, atol=0)  # of a full form several
    assert x[lowest].mean() == pytest.approx(length / 2, rel=1e-9)
    assert np.all(np.diff(z[: keel + 1]) <= 1e-12)
    assert np.all(np.diff(x) >= -1e-12)


@pytest.mark.parametrize(("side", "outside"), [(0, -1e-3), (1, 1e-3)])
def test_the_range_of_a_lewis_form_is_as_wide_as_can_be(side, outside):
    within = lewis(140.0, 8.0, 0.7)
    object.__setattr__(within, "area_coefficient", within.fullness[side] + outside)
    chain = within.section()
    below = chain[1:-1, 1]
    assert below.min() < -8 - 1e-9 or below.max() > -1 + 1e-9


def test_a_lewis_form_of_a_half_circle_s_proportions_has_the_range_of_closed_form():
    assert lewis(18.0, 10.0, 0.7).fullness == pytest.approx(
        (math.pi / 4 * 3 / 8, math.pi / 4 * 39 / 32)
    )


def test_a_lewis_form_is_stretched_up_to_its_range():
    longest = lewis(79.5, 10.0, 0.9)
    assert stretched(lewis(40.0, 10.0, 0.9), longest.outline.area).length == pytest.approx(79.5)


@pytest.mark.parametrize("name", NAMES)
def test_a_stretched_hull_displaces_what_was_asked_for_at_its_draft(name):
    found = stretched(hull(name), 333.0)
    assert found.outline.area == pytest.approx(333, rel=1e-12)
    assert found.draft == hull(name).draft
    assert stretched(hull(name), None) is hull(name)


def test_an_area_that_no_length_gives_is_refused_by_name():
    with pytest.raises(InputError, match="displacement=3: no length"):
        stretched(hull("rounded_box"), 3.0)


def test_chords_enclose_the_ellipse_with_third_order():
    """Points are moved out by what chords stray inwards, all but three: ends and keel."""
    shape = {"length": 40.0, "draft": 10.0, "wall": 1.0}
    exact = 40 + math.pi / 4 * 40 * 9
    outlines = [HalfEllipse(**shape, segments=n).outline for n in (20, 40, 80, 160)]
    errors = np.array([exact - outline.area for outline in outlines])
    assert np.log2(errors[:-1] / errors[1:]) == pytest.approx([3, 3, 3], abs=0.05)
    assert {(outline.length, outline.draft) for outline in outlines} == {(40.0, 10.0)}


def test_pitch_turns_about_waterline_or_centroid():
    half = Rectangle(length=40.0, draft=10.0, pitch_center="centroid").outline
    assert half.center == pytest.approx([20, -5])
    assert hull("rectangle").outline.center == pytest.approx([20, 0])


def test_polygon_keeps_vertical_walls_and_cuts_sloped_ones_at_the_wall():
    box = Polygon(points=BOX, length=4.0, draft=1.0, wall=0.1).outline
    assert box.wall_height == pytest.approx(1)
    wedge = Polygon(points=((0, 0), (2, -1), (4, 0)), length=4.0, draft=1.0, wall=0.25).outline
    assert wedge.wall_height == pytest.approx(0.25)
    assert wedge.area == pytest.approx(4 * 0.25 + 4 * 0.75 / 2)


def test_points_in_metres_stay_where_they_are_unless_sizes_are_given():
    points = ((0, 0), (0, -5), (10, -8), (100, -8), (120, -4), (120, 0))
    x, z = np.array(points, float).T
    shoelace = abs(np.dot(x, np.roll(z, -1)) - np.dot(z, np.roll(x, -1))) / 2
    key = f"hull.points={[list(point) for point in points]}"
    drawn = validate(compose("equilibria", "hull=polygon", key, "channel.depth=12"))
    assert (drawn.case.hull.length, drawn.case.hull.draft) == (120, 8)
    assert drawn.config["hull"]["length"] == 120
    assert drawn.config["hull"]["draft"] == 8
    outline = drawn.case.hull.outline
    assert outline.vertices == pytest.approx(np.array(points), abs=1e-12)
    assert outline.area == pytest.approx(shoelace, rel=1e-14)
    longer = hull("polygon", key, "hull.length=240.0")
    assert (longer.length, longer.draft) == (240, 8)
    assert longer.outline.area == pytest.approx(2 * shoelace, rel=1e-14)


def test_sloped_sides_keep_their_points_below_the_walls():
    wedge = Polygon(points=((0, 0), (2, -1), (4, 0)), wall=0.25)
    assert (wedge.length, wedge.draft) == (3, 1)
    assert wedge.outline.area == pytest.approx(3 * 0.25 + 3 * 0.75 / 2)


def test_walls_that_shorten_a_hull_are_remarked_on():
    barge = ((0, 0), (0, -0.5), (12, -3.2), (100, -3.2), (110, -0.5), (110, 0))
    cut = Polygon(points=barge, wall=1.0)
    assert cut.length == pytest.approx(110 - 0.5 * (12 + 10) / 2.7)
    assert "105.926 m long of 110 m drawn" in cut.remark()
    assert "hull.wall=1 m;" in cut.remark()
    assert Polygon(points=barge, wall=0.5).remark() == ""
    assert Polygon(points=barge, wall=1.0, length=55.0).remark() == ""  # as long as asked for


def test_a_channel_that_is_short_ahead_of_its_ship_is_remarked_on_with_what_to_give():
    ship = Rectangle(length=140.0, draft=8.0)
    line = CHANNEL.remark(ship)
    assert line.startswith("channel.upstream=40: short for a hull 140 m long;")
    assert "channel.upstream=140, and" in line
    assert line.endswith("channel.downstream=210")
    assert Channel(depth=11.0, upstream=140.0, downstream=60.0).remark(ship) == ""


@pytest.mark.parametrize("name", ["fig7", *NAMES])
def test_the_paper_s_and_all_ready_made_ships_draw_no_remark_in_their_channels(name):
    channel = "fig7" if name == "fig7" else "paper"
    case = validate(compose("limits", f"hull={name}", f"channel={channel}")).case
    assert case.channel.remark(case.hull) == ""


def test_a_curve_is_as_long_and_deep_as_its_chords():
    found = hull("curve")
    vertices = found.outline.vertices
    assert found.draft == pytest.approx(-vertices[:, 1].min(), rel=1e-12)
    assert found.length == pytest.approx(vertices[-1, 0] - vertices[0, 0], rel=1e-12)
    apart = np.abs(vertices[1:-1, None] - found.curve()).max(axis=2)
    assert apart.min(axis=1).max() < 1e-9


SHIPS = {
    "shipped": tuple(map(tuple, compose("equilibria", "hull=curve")["hull"]["points"])),
    "open": ((0, 0), (0, -1), (8, -8), (110, -8), (140, -3), (140, 0)),
    "tunnel": ((0, 2), (0, -2), (9, -8), (25, -8), (30, -5), (34, -6), (40, -2), (40, 2)),
}


@pytest.mark.parametrize("points", SHIPS.values(), ids=SHIPS)
@pytest.mark.parametrize("segments", [3, 60, 400])
def test_a_curve_has_the_bounding_box_of_its_points_and_turns_back_at_none_but_them(
    points, segments
):
    curve = Curve(points=points, wall=0.5, segments=segments)
    drawn = curve.curve()
    for found, given in zip(drawn.T, np.array(points, float).T, strict=True):
        assert (found.min(), found.max()) == (given.min(), given.max())
    corners = [int(np.argmin(np.abs(drawn - point).sum(axis=1))) for point in points]
    assert drawn[corners] == pytest.approx(np.array(points), abs=1e-12)
    for part in np.split(drawn, corners[1:]):
        for steps in np.diff(part, axis=0).T:
            assert np.all(steps <= 0) or np.all(steps >= 0)
    assert curve.draft == -min(z for _, z in points)


def test_a_flat_keel_and_upright_sides_of_a_curve_are_a_chord_each():
    x, z = Curve(points=SHIPS["shipped"], wall=1.0, segments=200).curve().T
    assert list(x[z == -10]) == [12, 28]
    assert list(z[(x == 0) & (np.abs(z) <= 2)]) == [2, -2]


def test_chords_of_a_ship_with_a_long_keel_close_in_on_its_curve_with_their_square():
    ends = (0, 0), (0, -6), (4, -12), (14, -14.5), (230, -14.5)
    points = (*ends, (260, -12), (285, -6), (300, -3), (300, 0))
    drawn = {n: LinearRing(Curve(points=points, wall=2.0, segments=n).curve()) for n in (60, 120)}
    curve = Curve(points=points, wall=2.0, segments=400).curve()
    strays = {n: max(ring.distance(Point(p)) for p in curve) for n, ring in drawn.items()}
    assert strays[60] / strays[120] == pytest.approx(4, rel=0.1)
    # Shared out by length, a bow of 14 m would have three of 60 chords, which stray by 0.8 m.
    assert strays[60] < 0.05


@pytest.mark.parametrize("kind", ["polygon", "curve"])
@pytest.mark.parametrize(
    ("points", "end"),
    [
        ("[[0,0],[0,-1],[8,-8],[110,-8],[140,-3]]", "last point, [140, -3], lies"),
        ("[[0,3],[0,0],[0,-1],[8,-8],[110,-8],[140,-3]]", "last point, [140, -3], lies"),
        ("[[0,-1],[8,-8],[110,-8],[140,-3],[140,0]]", "first point, [0, -1], lies"),
        ("[[0,-1],[8,-8],[110,-8],[140,-3]]", "first point, [0, -1], lies"),
    ],
)
def test_a_list_that_lacks_a_point_on_the_water_line_is_refused_by_its_end(kind, points, end):
    with pytest.raises(InputError) as caught:
        hull_of(kind, points)
    assert str(caught.value).startswith(f"hull.points: the {end} below the water; begin and end")


def hull_of(kind, points):
    return validate(compose("equilibria", f"hull={kind}", f"hull.points={points}")).case.hull


def test_a_closed_list_may_begin_anywhere():
    ring = np.array([(0, 2), (0, -2), (8, -8), (30, -8), (40, -2), (40, 2)], float)
    found = [
        Polygon(points=tuple(map(tuple, np.roll(ring, k, axis=0))), wall=1.0).outline
        for k in range(len(ring))
    ]
    assert [one.area for one in found] == pytest.approx([found[0].area] * len(ring))


@pytest.mark.parametrize(
    ("changes", "words"),
    [
        ({"points": ((0, 0), (4, -1), (4, 0), (0, -1))}, "hull.points: the outline crosses itself"),
        ({"points": ((0, 1), (0, 2), (4, 2))}, "none lies below the water line"),
        ({"wall": 2.0}, "hull.wall=2: must be less than hull.draft=1"),
        (
            {
                "points": (
                    (0, 0),
                    (0, -1),
                    (1, -1),
                    (1, 0),
                    (3, 0),
                    (3, -1),
                    (4, -1),
                    (4, 0),
                    (2, 1),
                )
            },
            "more than once",
        ),
    ],
)
def test_impossible_outline_is_refused_by_name(changes, words):
    given = {"points": BOX, "length": 4.0, "draft": 1.0, "wall": 0.1, **changes}
    with pytest.raises(InputError, match=words):
        _ = Polygon(**given).outline


def test_curve_with_coinciding_points_is_refused_by_name():
    points = ((0, 1), (0, 1), (0, -1), (4, -1), (4, 1))
    curve = Curve(points=points, length=4.0, draft=1.0, wall=0.1, segments=30)
    with pytest.raises(InputError, match="two neighbours coincide"):
        _ = curve.outline


@pytest.mark.parametrize(
    ("line", "words"),
    [
        (["hull=v", "hull.wall=10.0"], "hull.wall=10: must be less than hull.draft=10"),
        (["hull=rounded_box", "hull.radius=11.0"], "hull.radius=11: must be less"),
        (["hull=lewis", "hull.segments=2"], "hull.segments=2"),
        (["hull=half_ellipse", "hull.segments=25"], "hull.segments=25: must be even here; give 26"),
        (
            ["hull=lewis", "hull.length=140", "hull.draft=8"],
            "hull.area_coefficient=0.9: must be within 0.5596 and 0.8909 for a Lewis form",
        ),
        (["hull=lewis", "hull.area_coefficient=0.4"], "hull.area_coefficient=0.4: must be within"),
        (
            ["hull=polygon", "hull.points=[[0,0],[4,-9],[4,0],[0,-9]]"],
            "hull.points: the outline crosses itself",
        ),
        (["hull=polygon", "hull.wall=10.0"], "hull.wall=10: must be less than hull.draft=10"),
        (["hull=polygon", "hull.length=-1.0"], "hull.length=-1"),
        (["hull.length=inf"], "hull.length=inf"),
        (["hull.length=-1.0"], "hull.length=-1"),
        (["hull=half_ellipse", "hull.shape=egg"], "hull"),
        (["channel.bottom=[[0.0,1.0],[0.0,2.0]]"], "channel.bottom: x=0 follows x=0"),
        (["channel.bottom=[[0.0,21.0]]"], "channel.bottom: z=21 at x=0"),
        (["channel.depth=nan"], "channel.depth=nan"),
    ],
)
def test_impossible_input_is_refused_in_one_line(line, words):
    with pytest.raises(InputError) as caught:
        validate(compose("equilibria", *line))
    assert words in str(caught.value)
    assert "\n" not in str(caught.value)


def test_draft_beyond_depth_and_hull_on_the_bottom_are_refused_by_name():
    with pytest.raises(InputError, match=r"hull.draft=20: must be less than channel.depth=20"):
        check_afloat(Rectangle(length=40.0, draft=20.0), CHANNEL)
    sill = Channel(depth=20.0, upstream=9.0, downstream=9.0, bottom=((9.0, 0.0), (10.0, 11.0)))
    with pytest.raises(InputError, match=r"touches channel.bottom"):
        check_afloat(hull("rectangle"), sill)


def test_schema_has_no_hull_without_a_shape():
    with pytest.raises(ValidationError):
        TypeAdapter(AnyHull).validate_python({"length": 40.0, "draft": 10.0})
