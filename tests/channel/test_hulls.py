"""Hull sections: areas against closed forms, one config line, impossible ones refused by name."""

import math

import numpy as np
import pytest
from pydantic import TypeAdapter, ValidationError

from squat.channel import AnyHull, Channel, Curve, HalfEllipse, Polygon, Rectangle, check_afloat
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
        ("rounded_box", 400 - 2 * (1 - math.pi / 4) * 9, 2e-3),
        ("half_ellipse", 40 + math.pi / 4 * 40 * 9, 3e-3),
        ("lewis", 40 + 0.9 * 40 * 9, 6e-3),
    ],
)
def test_area_agrees_with_the_closed_form_but_for_the_chords(name, area, tolerance):
    assert hull(name).outline.area == pytest.approx(area, rel=tolerance)


def test_chords_converge_to_the_ellipse_with_second_order():
    shape = {"length": 40.0, "draft": 10.0, "wall": 1.0}
    exact = 40 + math.pi / 4 * 40 * 9
    errors = [exact - HalfEllipse(**shape, segments=n).outline.area for n in (20, 40, 80)]
    assert np.log2(errors[:-1] / np.array(errors[1:])) == pytest.approx([2, 2], abs=0.01)


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
