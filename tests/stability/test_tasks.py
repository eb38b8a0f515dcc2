"""The tasks `stability`, `limits` and `limits_map`: records, words, warnings, figures."""

import json
import math
import re

import numpy as np
import pytest
from matplotlib.backends.backend_agg import FigureCanvasAgg

from squat.channel import Channel, Rectangle
from squat.config import compose
from squat.errors import InputError
from squat.figures import limits as limits_figures
from squat.figures import stability as energy_figures
from squat.stability import limits, limits_map, portrait
from squat.stability.digits import measured
from squat.stability.equilibria import OneDimensionalModel
from squat.stability.formulas import FORMULAS, Particulars
from squat.stability.validity import warnings
from squat.water import Water

QUICK = "accuracy=study", "accuracy.near=0.32", "accuracy.far=0.4"
SMALL = "mesh=coarse", "cases/stability@speeds=small", "portrait=small"


@pytest.fixture(scope="module")
def small(case):
    return drawable(portrait.run(case("stability", *SMALL)))


def drawable(data):
    """With the configuration that a record would have."""
    return data.assign_attrs(config=json.dumps(compose("stability", *SMALL)))


def particulars(**changes):
    given = {"length": 230.0, "draft": 12.0, "block": 0.7, "depth": 15.0, "speed": 5.0}
    given |= {"gravity": 9.81, "beam": 32.0, "width": None}
    return Particulars(**(given | changes))


def answer(name, **changes):
    return next(one for one in FORMULAS if one.name == name).answer(particulars(**changes))


def test_portrait_is_consistent_with_itself(small):
    """Limits where the curves end, map and start agree, separatrices on the potential."""
    limit, fold = float(small["dynamic_squat_speed"]), float(small["squat_speed_2d"])
    speed = small["speed"].values
    assert np.array_equal(np.isfinite(small["stable"]), speed < fold)
    assert np.array_equal(np.isfinite(small["lowest"]), speed < limit)
    below = speed < limit
    assert (small["lowest"] <= small["highest"])[below].all()
    assert (small["lowest"] > small["unstable"])[below & np.isfinite(small["unstable"])].all()
    assert (small["period"] > small["linear_period"])[(speed > 1) & below].all()
    assert limit < fold < float(small["squat_speed_1d"])
    assert float(small.attrs["squat_speed_bracket"]) <= 1e-8


LONG = (
    "mesh.near=2", "mesh.far=4", "hull.length=140", "hull.draft=8", "channel.depth=11",
    "channel.upstream=140", "channel.downstream=210", "portrait=small", "speeds.points=31",
)  # fmt: skip


def test_a_slow_ship_is_asked_about_speeds_heaves_and_velocities_of_its_own(case):
    data = portrait.run(case("stability", *LONG))
    fold = float(data["squat_speed_2d"])
    assert 0.3 * fold < data["case_speed"].min() < data["case_speed"].max() < fold < 1
    assert np.isfinite(data["case_stable"]).all()
    assert fold < float(data["speed"].max()) < 1.3 * fold
    assert np.isfinite(data["limit_map"]).all()
    assert (data["limit_map"][:, -1] < 0.8 * fold).all()


def test_the_paper_s_ship_is_asked_about_the_printed_speeds(case):
    own = portrait.run(case("stability", "mesh=coarse", "portrait=own", "speeds.points=2"))
    given = case("stability", "cases/stability@speeds=paper", "portrait=paper")
    assert own["case_speed"].values.tolist() == list(given.speeds.cases)
    assert float(own["speed"].max()) == given.speeds.greatest
    for name, ends in (
        ("initial_heave", given.portrait.heaves),
        ("initial_velocity", given.portrait.velocities),
    ):
        assert own[name].values[[0, -1]].tolist() == [ends.least, ends.greatest]


@pytest.mark.parametrize(
    ("key", "said"),
    [
        ("speeds.least=9", "speeds.least=9: must be less than speeds.greatest=3"),
        (
            "portrait.heaves.least=3",
            "portrait.heaves.greatest=2: must exceed portrait.heaves.least=3",
        ),
    ],
)
def test_a_start_beyond_the_ship_s_own_end_is_refused(case, key, said):
    with pytest.raises(InputError, match=re.escape(said)):
        portrait.run(case("stability", *SMALL[::2], key))


def test_a_single_speed_is_the_least_wherever_the_curve_would_end(case):
    speeds = case("equilibria", "speeds.points=1", "speeds.least=2", "speeds.greatest=2").speeds
    assert speeds.curve(2.5).tolist() == [2.0]


def test_map_of_limits_is_bounded_by_the_separatrices(small):
    heave, velocity = small["initial_heave"].values, small["initial_velocity"].values
    for n, speed in enumerate(small["case_speed"].values):
        loop = small["separatrix_heave"].values[n]
        edge = np.interp(heave, loop, small["separatrix_velocity"].values[n], left=-1, right=-1)
        inside = velocity[None, :] < edge[:, None]
        # Straight lines between the loop's points: starts within 1 % of the edge are left out.
        clear = np.abs(velocity[None, :] - edge[:, None]) > 0.01
        clear &= (heave[:, None] > loop[0]) | (velocity[None, :] > 0)
        assert np.array_equal((small["limit_map"].values > speed)[clear], inside[clear])


def test_limits_hold_what_a_finer_set_of_meshes_says(case):
    """The stated errors are honest: the next finer meshes lie within them."""
    rough = limits.run(case("limits", *QUICK, "current=2.25"))
    fine = limits.run(case("limits", "current=2.25"))
    for name in ("equilibrium", "least_clearance", "period"):
        assert abs(float(rough[name] - fine[name])) < float(rough[f"{name}_error"])
    apart = np.abs(rough["limit_speed"] - fine["limit_speed"])
    assert (apart[1:] < rough["limit_error"][1:]).all()
    assert (fine["limit_error"] < 2e-6).all()


def test_captions_of_the_report_state_the_extrapolated_limits(case):
    contents = case("report", "results=none").contents
    found = limits.run(case("limits", "accuracy=study")).set_index(limit="limit")["limit_speed"]
    text = next(block.text for block in contents.blocks if block.figure == "limits")
    two, dynamic = (f"{float(found.sel(limit=name)):.3f}" for name in ("2D", "dynamic"))
    assert f"they are {two} (2D) and {dynamic} m/s (dynamic" in text
    trimmed = next(block.text for block in contents.blocks if block.figure == "trim")
    assert f"extrapolated {two} and {dynamic} m/s" in trimmed


def test_a_speed_above_the_limits_is_answered_too(case):
    data = limits.run(case("limits", *QUICK, "current=2.5"))
    assert math.isnan(data["least_clearance"])
    assert math.isfinite(data["equilibrium"])
    first = str(data["warning"].values[0])
    assert first == (
        "at 2.5 m/s the ship set free at w(0) = -0.1 m with w'(0) = 0 m/s is lost though there "
        "is an equilibrium"
    )
    assert first in data.attrs["summary"]
    beyond = limits.run(case("limits", *QUICK, "current=2.7"))
    assert "there is no equilibrium" in str(beyond["warning"].values[0])
    assert "equilibrium           w = none" in beyond.attrs["summary"]


def test_impossible_questions_are_refused_by_name(case):
    with pytest.raises(InputError, match=r"start\.heave=-9\.9: must be between grounding at -9\.8"):
        limits.run(case("limits", *QUICK, "start.heave=-9.9"))
    with pytest.raises(InputError, match=r"width=30: means nothing without beam="):
        case("limits", "width=30.0")
    with pytest.raises(InputError, match=r"width=30: must be at least beam=40"):
        case("limits", "width=30.0", "beam=40.0")


def test_the_1d_squat_speed_is_schijfs_limit_speed():
    """1 - S + Fr^2/2 - 3/2 Fr^(2/3) = 0 with S = T/H is the discriminant of Eq. (27)."""
    for draft in (2.0, 10.0, 18.0):
        model = OneDimensionalModel(
            Rectangle(length=40.0, draft=draft),
            Channel(depth=20.0, upstream=1.0, downstream=1.0),
            Water(density=1000.0, gravity=9.81),
        )
        froude = model.squat_speed().speed / math.sqrt(9.81 * 20)
        assert 1 - draft / 20 + froude**2 / 2 - 1.5 * froude ** (2 / 3) == pytest.approx(
            0, abs=1e-12
        )


def test_schijf_keeps_water_and_head():
    """Continuity and Bernoulli with the level lowered by the squat, for a narrow ship too."""
    ship = particulars(width=150.0, speed=3.0)
    z = answer("Schijf", width=150.0, speed=3.0).squat
    section = 150.0 * 15.0
    faster = 3.0 * section / (section - 32.0 * 12.0 - 150.0 * z)
    assert (faster**2 - 3.0**2) / (2 * 9.81) == pytest.approx(z, rel=1e-10)
    assert ship.blockage == pytest.approx(32 * 12 / section)


def test_formulas_follow_their_scaling():
    assert answer("Barrass", width=120.0, speed=6.0).squat / answer(
        "Barrass", width=120.0, speed=3.0
    ).squat == pytest.approx(2**2.08)
    slow, fast = (answer("Tuck/ICORELS", speed=v).squat for v in (0.01, 0.02))
    assert fast / slow == pytest.approx(4, rel=1e-4)
    open_water, canal = (answer("Huuska/Guliev", width=w).squat for w in (None, 200.0))
    assert canal / open_water == pytest.approx(7.45 * 32 * 12 / (200 * 15) + 0.76)
    full = {"block": 0.85, "length": 216.0}
    assert answer("Eryuzlu", speed=4.0, **full).squat / answer(
        "Eryuzlu", speed=2.0, **full
    ).squat == pytest.approx(2**2.289)


@pytest.mark.parametrize(
    ("name", "changes", "reason"),
    [
        ("Schijf", {}, "needs width= of the channel"),
        ("Barrass", {"width": 1000.0}, "S = 0.0256 is outside 0.1 to 0.266"),
        ("Barrass", {"width": 120.0, "block": 0.90004}, "C_B of the section = 0.90004 is outside"),
        ("Tuck/ICORELS", {"beam": None}, "needs beam= of the ship"),
        ("Tuck/ICORELS", {"width": 200.0}, "for open water; leave width= out"),
        ("Tuck/ICORELS", {"speed": 10.0}, "Fr_h = 0.824 is outside 0 to 0.7"),
        ("Huuska/Guliev", {"block": 0.9}, "C_B of the section = 0.9 is outside 0.6 to 0.8"),
        ("Eryuzlu", {"depth": 40.0}, "H/T = 3.33 is outside 1.1 to 2.5"),
    ],
)
def test_formulas_out_of_range_say_why(name, changes, reason):
    found = answer(name, **changes)
    assert math.isnan(found.squat)
    assert reason in found.note


def test_the_ends_of_a_range_belong_to_it_whatever_rounding_says(case):
    for depth in (1.5 * 12.0 * (1 + 1e-15), 1.1 * 12.0 * (1 - 1e-15)):
        assert answer("Barrass", width=120.0, depth=depth, block=0.9 * (1 + 1e-15)).squat > 0
    lewis = ("hull=lewis", "hull.length=90.0", "hull.draft=6.0", "hull.area_coefficient=0.85")
    river = ("channel.depth=9.0", "channel.upstream=90.0", "beam=14.0", "width=80.0")
    data = limits.run(case("limits", *QUICK, *lewis, *river))
    assert data["formula_squat"].sel(formula="Barrass") > 0


def test_numbers_are_printed_with_the_digits_that_they_deserve():
    assert measured(2.39978809, 1.01e-6, "m/s") == "2.3997881 +- 1.0e-06 m/s"
    assert measured(123.456, 7.0, "m") == "123.5 +- 7.0e+00 m"
    assert measured(math.nan, 1.0, "m") == "none"


def test_limits_over_geometry_tend_to_1d_for_long_ships(case):
    data = limits_map.run(
        case(
            "limits_map",
            "depth_over_draft=[1.5,2]",
            "length_over_draft=[2,4]",
            "accuracy.near=0.32",
            "accuracy.far=0.4",
        )
    )
    two, one = data["limit_2d"], data["limit_1d"]
    assert (data["limit_dynamic"] < two).all()
    assert (two < one).all()
    share = (two / one).values
    assert (np.diff(share, axis=0) > 0).all()  # with L/T
    assert (np.diff(share, axis=1) < 0).all()  # with H/T
    at = data.sel(length_over_draft=4, depth_over_draft=2)
    here = limits.run(case("limits", *QUICK))
    apart = abs(float(at["limit_2d"]) - float(here["limit_speed"][1]))
    assert apart < float(at["limit_2d_error"])
    limits_figures.limits_map(data)


DRAWN = [
    energy_figures.potential,
    energy_figures.phase_portrait,
    limits_figures.limits,
    limits_figures.basins,
]


@pytest.mark.parametrize("draw", DRAWN)
def test_figures_draw_with_nothing_cut_off(small, draw):
    figure = draw(small)
    FigureCanvasAgg(figure).draw()
    for axes in figure.axes:
        for text in (axes.title, axes.xaxis.label, axes.yaxis.label):
            box = text.get_window_extent()
            assert not text.get_text() or figure.bbox.contains(box.x0, box.y0)
            assert not text.get_text() or figure.bbox.contains(box.x1, box.y1)


def test_figures_stand_speeds_beyond_every_limit(case):
    data = drawable(portrait.run(case("stability", *SMALL, "speeds.cases=[2.9,1]")))
    for draw in DRAWN:
        FigureCanvasAgg(draw(data)).draw()


def warnings_of(case, clearance):
    data = {"limit_speed": [3.0, 2.9, 2.8], "equilibrium": -0.1, "under_keel_clearance": clearance}
    return warnings(case, data)


@pytest.mark.parametrize(("current", "warned"), [("1.0", True), ("0.0", False)])
def test_a_boundary_layer_that_fills_the_gap_is_warned_of(case, current, warned):
    keys = "hull.length=400.0", "hull.draft=18.0", f"current={current}"
    found = warnings_of(case("limits", *QUICK, *keys), clearance=1.8)
    assert any("no viscosity" in text for text in found) == warned


def test_where_there_is_no_equilibrium_the_gap_is_that_at_rest(case):
    keys = "hull.length=400.0", "hull.draft=18.0", "current=1.0"
    (found,) = (
        text
        for text in warnings_of(case("limits", *QUICK, *keys), clearance=math.nan)
        if "no viscosity" in text
    )
    assert found.endswith("of the gap at rest")


@pytest.mark.parametrize(("hull", "told"), [("rectangle", False), ("lewis", True), ("curve", True)])
def test_what_chords_leave_out_is_minded_where_there_are_any(case, hull, told):
    found = warnings_of(case("limits", *QUICK, f"hull={hull}"), clearance=9.0)
    assert any("hull.segments=" in text for text in found) == told


def test_a_short_ship_with_much_water_below_is_not_warned_of_viscosity(case):
    found = warnings_of(case("limits", *QUICK, "hull.length=10.0"), clearance=10.0)
    assert not any("no viscosity" in text for text in found)


def test_numbers_are_given_with_the_digits_that_they_deserve():
    assert measured(2.5, 0.0, "m") == "2.5 m"
    assert measured(2.0 / 3.0, math.inf, "m") == "0.666667 m"
    assert measured(math.nan, 0.1, "m") == "none"
    assert measured(2.0 / 3.0, 0.012, "m") == "0.667 +- 1.2e-02 m"


def test_a_box_has_block_coefficient_one(case):
    data = limits.run(case("limits", *QUICK, "beam=8.0"))
    notes = dict(zip(data["formula"].values, data["formula_note"].values, strict=True))
    assert "C_B of the section = 1 is outside" in notes["Huuska/Guliev"]


def test_a_cell_of_the_map_is_the_answer_about_that_ship(case):
    """L/T = 4 and H/T = 2 with T = 10 m is the ship of section 3.6."""
    one = limits_map.cell(case("limits_map", *QUICK), 4.0, 2.0)
    data = limits.run(case("limits", *QUICK))
    assert [one.limit_1d, one.limit_2d, one.limit_dynamic] == pytest.approx(
        data["limit_speed"].values, rel=1e-9
    )
    assert [one.limit_2d_error, one.limit_dynamic_error] == pytest.approx(
        data["limit_error"].values[1:], rel=1e-3
    )
    assert 0 > one.sinkage_2d > -10
    assert 0 > one.sinkage_1d > -10


@pytest.mark.parametrize(
    ("keys", "said"),
    [
        (("hull=half_ellipse",), "1D limit: takes the hull for a box"),
        (("channel.bottom=[[10,0],[20,4]]",), "take the bottom for flat"),
        (("free_surface=blend",), "blend: the hull's motion feels zero pressure"),
        ((), "rigid lid: the lowering of the surface"),
    ],
)
def test_what_the_model_leaves_out_is_said(case, keys, said):
    found = warnings_of(case("limits", *QUICK, *keys), clearance=9.9)
    assert any(text.startswith(said) or said in text for text in found)
