"""Roots of Eq. (27), their stability, and the squat speed."""

import math
import re

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from squat.channel import Channel, Rectangle
from squat.errors import InputError
from squat.fluid.run import run as added_mass
from squat.stability.equilibria import OneDimensionalModel
from squat.stability.keel import squat_speed
from squat.stability.run import run
from squat.stability.speeds import readable
from squat.water import Water

WATER = Water(density=1000.0, gravity=9.81)


def model(depth=20.0, draft=10.0, length=40.0):
    hull = Rectangle(length=length, draft=draft)
    return OneDimensionalModel(hull, Channel(depth=depth, upstream=1.0, downstream=1.0), WATER)


geometries = st.builds(
    lambda depth, ratio, length: model(depth, depth * ratio, length),
    st.floats(0.1, 1e4),
    st.floats(0.01, 0.98),
    st.floats(0.1, 1e4),
)


@given(geometries, st.floats(0.001, 0.999))
def test_roots_are_those_of_the_printed_polynomial(ship, fraction):
    speed = fraction * ship.squat_speed().speed
    roots = np.array(ship.roots(speed))
    expected = np.sort(np.roots(ship.coefficients(speed)).real)[::-1]
    # np.roots loses half the digits where two roots nearly merge.
    assert roots == pytest.approx(expected, rel=1e-6, abs=1e-6 * ship.channel.depth)


@given(geometries)
def test_the_closed_form_of_the_squat_speed_is_the_bracketed_one(ship):
    closed = squat_speed(ship.channel.depth, ship.clearance, WATER.gravity)
    assert closed == pytest.approx(ship.squat_speed().speed, rel=1e-9)


@given(geometries, st.floats(0.001, 0.999))
def test_force_vanishes_and_slopes_have_opposite_signs(ship, fraction):
    speed = fraction * ship.squat_speed().speed
    stable, unstable, below = ship.roots(speed)
    scale = WATER.density * WATER.gravity * ship.hull.length * ship.channel.depth
    clearance = ship.clearance + unstable
    for w in (stable, unstable):
        # Rounding of w moves the force by stiffness * eps * depth.
        slack = abs(ship.stiffness(w, speed)) * ship.channel.depth + scale
        assert abs(ship.force(w, speed)) < 1e-13 * slack
    assert ship.stiffness(stable, speed) > 0 > ship.stiffness(unstable, speed)
    assert below < -ship.clearance < unstable < stable <= 0
    assert clearance > 0


@given(geometries)
def test_squat_speed_is_a_double_root(ship):
    fold = ship.squat_speed()
    # 27 r = 4 q^3 is the vanishing discriminant of the cubic in the clearance.
    head = fold.speed**2 / (2 * WATER.gravity)
    q, r = ship.clearance + head, head * ship.channel.depth**2
    assert 27 * r / (4 * q**3) == pytest.approx(1, abs=1e-11)
    assert fold.sinkage == pytest.approx(2 * q / 3 - ship.clearance, rel=1e-9, abs=1e-9 * q)
    above = ship.roots(fold.speed * (1 + 1e-9))
    below = ship.roots(fold.speed * (1 - 1e-9))
    assert np.isnan(above.stable)
    assert np.isnan(above.unstable)
    assert below.unstable < fold.sinkage < below.stable


def test_squat_speed_is_bracketed_to_1e_12():
    fold = model().squat_speed()
    assert fold.width <= 1e-12
    at = [float(model().roots(fold.speed + sign * fold.width / 2).stable) for sign in (-1, 1)]
    assert np.isfinite(at[0])
    assert np.isnan(at[1])


def test_third_root_is_real_above_the_squat_speed():
    ship = model()
    speed = np.array([3.0, 4.0, 50.0])
    below = ship.roots(speed).unphysical
    lowest = [
        min(roots, key=lambda z: z.real).real for roots in map(np.roots, ship.coefficients(speed))
    ]
    assert below == pytest.approx(lowest, rel=1e-12)
    assert np.abs(ship.force(below, speed)).max() < 1e-6


def test_roots_over_the_water_line_are_no_equilibria():
    """At 50 m/s the cubic has three real roots again, the upper two with the hull in the air."""
    ship = model()
    assert np.sort(np.roots(ship.coefficients(50.0)).real)[1] > ship.hull.draft
    assert np.isnan(ship.roots(50.0).stable)
    assert np.isnan(ship.roots(50.0).unstable)


def test_at_rest_the_ship_floats_and_the_lower_roots_lie_on_the_bottom():
    assert np.array(model().roots(0.0)) == pytest.approx([0, -10, -10], abs=1e-15)
    assert model().stiffness(-10.0, 0.5) == -np.inf


def test_stiffness_is_the_slope_of_the_force():
    ship, w, h = model(), np.linspace(-8, 1, 13), 1e-6
    slope = (ship.force(w + h, 2.0) - ship.force(w - h, 2.0)) / (2 * h)
    assert -slope == pytest.approx(ship.stiffness(w, 2.0), rel=1e-7)


def test_period_at_rest_is_that_of_a_floating_body():
    ship = model()
    inertia = 4.6612 * 1000 * 400
    expected = 2 * np.pi * np.sqrt(inertia / (1000 * 9.81 * 40))
    assert ship.period(0.0, 0.0, inertia) == pytest.approx(expected, rel=1e-14)
    assert np.isnan(ship.period(-8.0, 2.0, inertia))


def test_vectorised_over_speed_equals_one_by_one():
    speeds = np.linspace(0, 4, 23)
    together = np.array(model().roots(speeds))
    alone = np.array([model().roots(v) for v in speeds]).T
    assert np.array_equal(together, alone, equal_nan=True)


def test_draft_beyond_the_depth_is_refused_by_name():
    with pytest.raises(InputError, match=r"hull.draft=30: must be less than channel.depth=20"):
        model(draft=30.0)


def test_dataset_holds_curve_cases_and_fold(case):
    data = run(case("equilibria", "accuracy=coarse"))
    assert float(data["speed"].min()) == 0
    assert float(data["speed"].max()) == 4
    below = data.sel(speed=data["speed"] < data["squat_speed"])
    assert np.isfinite(below["period"]).all()
    assert (np.diff(below["period"]) > 0).all()


@pytest.mark.parametrize("ratio", [0.0, 2.0])
def test_period_in_still_water_is_that_of_ship_and_added_mass_on_its_spring(case, ratio):
    data = run(case("equilibria", f"added_mass_ratio={ratio}"))
    hull = case("equilibria").hull
    assert float(data["period"][0]) == pytest.approx(
        2 * math.pi * math.sqrt((1 + ratio) * hull.draft / 9.81), rel=1e-12
    )


LONG = "hull.length=140", "hull.draft=8", "channel.depth=11", "accuracy=coarse"


def test_the_period_is_that_of_the_added_mass_of_the_very_hull(case):
    data = run(case("equilibria", *LONG))
    matrix = added_mass(case("added_mass", *LONG, "mesh=coarse"))
    ratio = float(matrix["mass_ratio"])
    assert ratio > 20
    assert float(data["added_mass_ratio"]) == pytest.approx(ratio, rel=1e-12)
    assert float(data["period"][0]) == pytest.approx(
        2 * math.pi * math.sqrt((1 + ratio) * 8 / 9.81), rel=1e-9
    )


def test_the_answer_in_words_tells_squat_speed_and_what_it_leaves_out(case):
    data = run(case("equilibria", "added_mass_ratio=2"))
    last = data.attrs["summary"].splitlines()[-1]
    speed, sinkage = re.match(r"squat speed (\S+) m/s .* at w = (\S+) m by", last).groups()
    assert float(speed) == pytest.approx(float(data["squat_speed"]), rel=1e-5)
    assert float(sinkage) == pytest.approx(float(data["squat_sinkage"]), rel=1e-3)
    assert "task=limits" in last
    assert "(as given)" in data.attrs["summary"]


def test_speeds_follow_the_ship_and_are_the_printed_ones_for_the_paper_s(case):
    own = run(case("equilibria", "added_mass_ratio=1"))
    printed = run(case("equilibria", "added_mass_ratio=1", "cases/squat@speeds=paper"))
    assert own["case_speed"].values.tolist() == printed["case_speed"].values.tolist()
    assert own["speed"].values.tolist() == printed["speed"].values.tolist()
    slow = run(case("equilibria", *LONG, "added_mass_ratio=1"))
    assert float(slow["case_speed"].max()) < float(slow["squat_speed"]) < 1


@given(st.floats(1e-6, 1e6), st.floats(-2, 2))
def test_numbers_are_rounded_to_a_hundredth_of_their_scale_or_better(scale, share):
    rounded = readable(share * scale, scale)
    assert abs(rounded - share * scale) <= 0.01 * scale * (1 + 1e-9)
    assert len(f"{abs(rounded) / 10 ** math.floor(math.log10(scale)):.10f}".rstrip("0")) <= 5
