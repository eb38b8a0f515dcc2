"""Loads over an uneven bottom: symmetry, far ramps, and what one dimension gets right."""

from dataclasses import replace

import numpy as np
import pytest

from squat import figures
from squat.config import compose, validate
from squat.errors import InputError
from squat.figures import uneven
from squat.stability import uneven_bottom
from squat.stability.box_ends import BoxEnd
from squat.stability.equilibria import OneDimensionalModel
from squat.stability.local_depth import LocalDepthModel
from squat.stability.sampling import Ship
from squat.stability.uneven_bottom import limit, loads, ramp

CASE = validate(compose("uneven_bottom", "accuracy.near=0.3", "accuracy.far=0.4")).case
WATER, HULL, CHANNEL = CASE.water, CASE.hull, CASE.channel
# Of the mesh's size of numbers: a channel's end at a distance d is felt as exp(-pi d/H) = 3e-6.
ENDS = 1e-5


def over(bottom=(), hull=HULL, **changes):
    return LocalDepthModel(hull, replace(CHANNEL, bottom=bottom, **changes), WATER)


def test_flat_bottom_is_eq_27_in_one_dimension_and_makes_no_moment():
    printed = OneDimensionalModel(HULL, CHANNEL, WATER)
    model = over()
    for w in (-4.0, 0.0, 1.0):
        expected = float(printed.force(w, 1.0) - printed.force(w, 0.0))
        assert model.force(w) == pytest.approx(expected, rel=1e-12)
        for one in (model, replace(model, complete=True)):
            assert one.moment(w) == pytest.approx(0.0, abs=1e-9 * abs(expected) * HULL.length)
    # A maximum found to 1e-9 m of its place is known to the square of it.
    assert model.squat_speed().speed == pytest.approx(printed.squat_speed().speed, rel=1e-12)


def test_flat_bottom_gives_the_heave_force_of_the_curves_and_of_the_exact_ends():
    found = loads(over(), CASE.accuracy, 2.0)
    ship = Ship(HULL, CHANNEL, WATER, "rigid_lid", CASE.grounding)
    curves = ship.on(CASE.accuracy.size(HULL, CHANNEL, 2)).at_current(2.0)
    error = found.flow.error[0]
    assert -float(curves.slope(0.0)) == pytest.approx(found.flow.value[0], abs=10 * error)
    force = abs(found.complete[0])
    assert found.flow.value[0] == pytest.approx(found.complete[0], abs=error + ENDS * force)
    assert abs(found.flow.value[1]) < 1e-4 * force * HULL.length


def test_an_end_of_a_narrow_slit_adds_two_over_pi_of_its_height():
    for gap in (1e-3, 1e-2):
        # The next term of the expansion in h/H is of second order.
        assert BoxEnd(gap, 1.0).length == pytest.approx(2 / np.pi * gap, rel=gap**2)


def test_moments_of_an_end_are_those_of_its_map_summed_along_it():
    end, b = BoxEnd(0.4, 1.0), 1 / 0.4**2

    def place(s):  # dx/ds of the map, midpoints in y = sqrt(|1 - s|)
        return (1 / np.pi) * np.sqrt(abs(1 - s)) / (s * np.sqrt(b - s))

    y = (np.arange(200_000) + 0.5) / 200_000
    s = 1 - y**2
    step = place(s) * 2 * y / len(y)
    x = np.cumsum(step) - step / 2
    excess = (1 - s / b) / (1 - s) - 1
    assert end.length == pytest.approx(excess @ step, rel=1e-4)
    assert end.keel_moment == pytest.approx(excess @ (x * step), rel=1e-3)
    t = 1 + (b - 1) * np.sin(y * np.pi / 2) ** 2
    step = place(t) * (b - 1) * np.sin(y * np.pi) * np.pi / 2 / len(y)
    z = np.cumsum(step) - step / 2
    assert z[-1] == pytest.approx(1.0 - 0.4, rel=1e-4)
    speed = (1 - t / b) / (t - 1)
    assert end.wall_moment(0.2) == pytest.approx(speed @ ((z - 0.2) * step), rel=1e-3)


def test_a_mirrored_bottom_mirrors_the_moment():
    sill = (8.0, 0.0), (12.0, 2.0), (16.0, 2.5), (26.0, 0.0)
    mirrored = tuple((HULL.length - x, z) for x, z in reversed(sill))
    ends = {"upstream": 90.0, "downstream": 90.0}
    one, two = (loads(over(bottom, **ends), CASE.accuracy, 1.0) for bottom in (sill, mirrored))
    error = one.flow.error + two.flow.error
    assert one.local == pytest.approx(two.local * [1, -1], rel=1e-12)
    assert one.complete == pytest.approx(two.complete * [1, -1], rel=1e-12)
    slack = error + ENDS * abs(one.flow.value[0]) * np.array([1, HULL.length])
    assert np.all(abs(one.flow.value - two.flow.value * [1, -1]) < slack)
    assert abs(one.flow.value[1]) > 20 * slack[1]


@pytest.mark.parametrize(("place", "depth"), [(-60.0, 20.0), (100.0, 17.0)])
def test_a_far_ramp_leaves_the_force_of_a_flat_channel_with_the_same_flux(place, depth):
    """Over the shelf the stream is faster, and the pressure lower by the difference of heads."""
    near = LocalDepthModel(HULL, ramp(CHANNEL, 3.0, 0.5, place), WATER)
    near = replace(near, channel=replace(near.channel, upstream=120.0, downstream=160.0))
    found = loads(near, CASE.accuracy, 1.0).flow
    speed = CHANNEL.depth / depth
    flat = loads(over(depth=depth), CASE.accuracy, speed).flow
    head = WATER.density / 2 * (1 - speed**2) * HULL.length
    slack = found.error + flat.error + 1e-4 * abs(flat.value[0]) * np.array([1, HULL.length])
    assert found.value[0] == pytest.approx(flat.value[0] + head, abs=slack[0])
    assert abs(found.value[1]) < slack[1]


def test_the_error_of_one_dimension_falls_with_the_gap_and_its_completion_leaves_none():
    gaps = 0.1, 0.05, 0.025
    found = [loads(CASE.slender(gap), CASE.accuracy, 1.0) for gap in gaps]
    plain = np.array([1 - one.local / one.flow.value for one in found])
    order = np.log2(plain[:-1] / plain[1:])
    # First order in h/L with a correction of the same order: 2^(1 + O(h/L)).
    assert order == pytest.approx(np.ones((2, 2)), abs=0.1)
    assert plain[-1][0] == pytest.approx(4 / np.pi * gaps[-1], rel=0.3)
    for one in found:
        # What is left is exponentially small in the ramp's distance from the ends over h.
        assert one.flow.value == pytest.approx(one.complete, abs=2 * one.flow.error.max())


def test_steeper_ramps_leave_the_second_order_of_curvature():
    """The force that a slope adds is V^2 rho H^2 s (h2 - h1)/(6 h1 h2), for small s."""
    gentle, steep = (
        loads(CASE.over(3.0, s, HULL.length / 2), CASE.accuracy, 1.0) for s in (0.25, 1.0)
    )
    missing = [1 - one.flow.value[0] / one.complete[0] for one in (gentle, steep)]
    assert abs(missing[0]) < 1e-3 < abs(missing[1])
    flat, curved = (
        one.force(0.0)
        for model in [replace(CASE.over(3.0, 0.25, 20.0), complete=True)]
        for one in (_without_slope(model), model)
    )
    assert flat - curved == pytest.approx(1000 * 400 * 0.25 * 3 / (6 * 70), rel=1e-12)


def _without_slope(model):
    x, weight, h, slope = model._rule
    changed = replace(model)
    changed.__dict__["_rule"] = x, weight, h, 0 * slope
    return changed


def test_the_moment_has_no_kink_where_a_corner_of_the_bottom_passes_under_the_stern():
    places = 54.5, 55.0, 55.5  # the crest of this ramp is 15 m ahead of its middle
    found = [loads(CASE.over(3.0, 0.1, place), CASE.accuracy, 1.0).flow for place in places]
    moment = np.array([one.value[1] for one in found])
    middle = (moment[0] + moment[2]) / 2
    assert moment[1] == pytest.approx(middle, rel=0.03)


def test_squat_speed_of_a_shelf_lies_below_the_one_dimensional_and_meets_its_completion():
    model = CASE.over(3.0, 0.25, HULL.length / 2)
    found = limit(model, CASE.accuracy, CASE.grounding)
    assert found.speed + found.error < found.local
    assert found.speed == pytest.approx(found.complete, rel=1e-3)


def test_record_and_figure_of_other_hulls_too():
    keys = "hull=half_ellipse", "cases/uneven_bottom@_global_=small"
    case = validate(compose("uneven_bottom", *keys)).case
    data = uneven_bottom.run(case)
    assert np.isnan(data["force_complete"]).all()
    assert np.all(data["force_1d"] < 0)
    assert figures.write.FIGURES["uneven_bottom"][1] is uneven.uneven_bottom
    uneven.uneven_bottom(data)


def test_a_bottom_of_the_channels_own_is_refused():
    with pytest.raises(InputError, match=r"channel\.bottom"):
        validate(compose("uneven_bottom", "channel.bottom=[[0,1]]"))
