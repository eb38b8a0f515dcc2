"""What a reader would complain of: labels over lines, titles cut off."""

import json
import math
from inspect import signature

import numpy as np
import pytest
import xarray as xr

from squat.cli.main import main
from squat.cli.tasks import TASKS
from squat.config import compose, validate
from squat.errors import InputError
from squat.figures.added_mass import sensitivity
from squat.figures.equilibria import fig10
from squat.figures.limits import _deepest, basins, limits
from squat.figures.stability import phase_portrait, potential
from squat.figures.trim import filled
from squat.figures.uneven import uneven_bottom
from squat.figures.write import FIGURES, FigureCase, catalogue
from squat.fluid.sensitivity import run as sensitivity_study
from squat.records.bottom_kinds import UNEVEN_BOTTOM
from squat.stability.portrait import run as stability
from squat.stability.run import run as equilibria


@pytest.mark.parametrize(("draft", "count"), [(10.0, 1), (9.0, 0)])
def test_table_7_is_drawn_beside_its_own_ship_alone(case, draft, count):
    keys = "equilibria", f"hull.draft={draft}"
    data = equilibria(case(*keys)).assign_attrs(config=json.dumps(compose(*keys)))
    figure = fig10(data)
    names = [text.get_text() for text in figure.legends[0].get_texts()]
    assert names.count("Table 7, printed") == count


@pytest.mark.parametrize(("hull", "told"), [("rectangle", ""), ("lewis", "a box of this draft")])
def test_roots_of_a_hull_that_is_no_box_are_told_to_be_of_a_box(case, hull, told):
    keys = "equilibria", f"hull={hull}"
    (axes,) = fig10(equilibria(case(*keys)).assign_attrs(config=json.dumps(compose(*keys)))).axes
    assert axes.get_title(loc="right").endswith(told)
    assert bool(axes.get_title(loc="right")) == bool(told)


def test_the_one_dimensional_curves_of_limits_say_what_they_take_the_hull_for(slow):
    assert limits(slow).axes[0].get_title(loc="right") == ""
    config = json.loads(slow.attrs["config"])
    config["hull"] = compose("stability", "hull=lewis")["hull"]
    (axes,) = limits(slow.assign_attrs(config=json.dumps(config))).axes
    assert axes.get_title(loc="right") == "1D: a box of this draft"


@pytest.fixture(scope="module")
def survived(case):
    """The energies of the paper's ship, at currents of which it survives some."""
    keys = "stability", "mesh=coarse", "portrait=small"
    return stability(case(*keys)).assign_attrs(config=json.dumps(compose(*keys)))


def test_the_motion_of_the_start_is_drawn_without_the_far_branch_of_its_energy(survived):
    """A slow ship's energy also admits places beyond the barrier, which it cannot reach."""
    data = survived
    slow = data.isel(case_speed=0)
    heave, potential = slow["heave"].values, slow["potential"].values
    own = np.interp(float(data["start_heave"]), heave, potential)
    barrier = float(slow["case_unstable"])
    assert (potential <= own)[heave < barrier].any()
    curve = phase_portrait(data).axes[0].collections[-1]
    found = np.vstack([path.vertices for path in curve.get_paths()])
    assert found[:, 0].min() > barrier


def test_the_small_motion_of_a_slow_ship_is_a_smooth_curve_over_the_dot_in_it(survived):
    axes = phase_portrait(survived).axes[0]
    curve, (dot,) = axes.collections[-1], [x for x in axes.lines if x.get_label() == "stable"]
    assert curve.get_zorder() > dot.get_zorder()
    found = np.vstack([path.vertices for path in curve.get_paths()])
    assert len(found) > 40
    assert float(survived["start_heave"]) == pytest.approx(found[:, 0].max(), abs=0.01)


def test_basins_hold_all_separatrices_and_say_where_the_map_ends(survived):
    axes = basins(survived).axes[0]
    (left, right), (low, high) = axes.get_xlim(), axes.get_ylim()
    loops = [line for line in axes.lines if line.get_label() != "start"]
    assert len(loops) > 2
    for x, z in (line.get_xydata()[np.isfinite(line.get_xydata()).all(axis=1)].T for line in loops):
        assert left < x.min()
        assert x.max() < right
        assert low < z.min()
        assert z.max() < high
    assert axes.get_title(loc="right") == "blank: beyond the map"


@pytest.fixture(scope="module")
def slow(case):
    """The energies of a ship in a shallow channel, at two speeds that it does not survive."""
    keys = "stability", "mesh=coarse", "portrait=small", "channel.depth=11"
    valid = validate(compose(*keys, "speeds.cases=[2,2.5]"))
    return stability(valid.case).assign_attrs(config=json.dumps(valid.config))


def test_a_legend_of_portraits_lists_what_is_drawn(slow):
    names = [text.get_text() for text in phase_portrait(slow).legends[0].get_texts()]
    assert names == ["energy of the start", "start"]
    for axes in phase_portrait(slow).axes:
        curve = np.vstack([path.vertices for path in axes.collections[-1].get_paths()])
        assert axes.get_xlim()[1] <= float(slow["heave"][-1])
        assert curve[:, 0].min() < -0.9
        assert curve[:, 1].max() < axes.get_ylim()[1] < 1.5 * curve[:, 1].max()
    named = [text.get_text() for text in potential(slow).legends[0].get_texts()]
    assert "stable" not in named


def test_axes_of_limits_and_basins_end_where_their_data_do(slow):
    (axes,) = limits(slow).axes
    fastest = float(max(slow["squat_speed_1d"], slow["squat_speed_2d"]))
    assert fastest < axes.get_xlim()[1] < 1.2 * fastest
    ends = {line.get_label(): line.get_xydata()[-1] for line in axes.lines}
    for name in ("1D", "2D"):
        fold = [float(slow[f"squat_{what}_{name.lower()}"]) for what in ("speed", "sinkage")]
        assert np.array_equal(ends[f"{name} stable"], fold)
        assert np.array_equal(ends[f"{name} unstable"], fold)
    reached, velocity = slow["initial_heave"].values[3:6], slow["initial_velocity"].values
    map_ = np.full((slow.sizes["initial_heave"], slow.sizes["initial_velocity"]), np.nan)
    map_[3:6] = [0.5, 0.4, *[0.0] * (len(velocity) - 2)]
    shown = slow.assign(limit_map=(("initial_heave", "initial_velocity"), map_))
    axes = basins(shown).axes[0]
    assert axes.get_xlim() == (reached[0], reached[-1])
    assert axes.get_ylim() == (-velocity[2], velocity[2])
    with pytest.raises(InputError, match=r"portrait\.heaves"):
        basins(shown.assign(limit_map=shown["limit_map"] * np.nan))


def test_the_list_of_figures_says_what_each_shows_and_of_which_task(monkeypatch, capsys):
    monkeypatch.setattr("sys.argv", ["squat", "task=figure", "figure=list"])
    main()
    rows = [line.split(maxsplit=2) for line in capsys.readouterr().out.splitlines()]
    assert {name: task for name, task, _ in rows} == {n: k.name for n, (k, _) in FIGURES.items()}
    assert {task for _, task, _ in rows} <= set(TASKS)
    assert all(len(shows.split()) > 3 for *_, shows in rows)
    with pytest.raises(ValueError, match="figure=list tells what each shows"):
        FigureCase(figure="fig99", data="x.nc")


@pytest.mark.parametrize("name", FIGURES)
def test_more_files_than_a_figure_draws_are_refused_and_the_list_tells_how_many(name):
    draw, shown = FIGURES[name][1], catalogue().splitlines()[list(FIGURES).index(name)]
    several = any(p.kind is p.VAR_POSITIONAL for p in signature(draw).parameters.values())
    assert ("files]" in shown) == several
    with pytest.raises(ValueError, match=f"figure={name}: draws .*, data names 9; give "):
        FigureCase(figure=name, data=("x.nc",) * 9)
    with pytest.raises(ValueError, match="data names 0; give "):
        FigureCase(figure=name, data=())
    if not several:
        with pytest.raises(ValueError, match="draws one run, data names 2; give one file"):
            FigureCase(figure=name, data=("safe.nc", "lost.nc"))


def _shelf():
    """A picture of made loads of a long ship, over three places, two gaps and three shelves."""
    sizes = {"steepness": 1, "place": 3, "gap_over_length": 2, "rise": 3}
    values = {
        name: (variable.dims, np.linspace(1.0, 2.0, math.prod(sizes[d] for d in variable.dims))
               .reshape([sizes[d] for d in variable.dims]))
        for name, variable in UNEVEN_BOTTOM.variables.items()
    }  # fmt: skip
    data = xr.Dataset(values).assign(length=190.0, clearance=2.5, shelf_rise=0.8)
    missing = {name: data[name] * np.nan for name in data if "complete" in name}
    return uneven_bottom(data.assign(missing))


def test_an_uneven_bottom_is_stretched_to_be_seen_and_its_keys_name_what_is_drawn():
    sketch, force, _, errors, speeds = _shelf().axes
    assert f"heights × {sketch.get_aspect():g}" in [text.get_text() for text in sketch.texts]
    assert sketch.get_aspect() > 10
    names = [[t.get_text() for t in a.get_legend().get_texts()] for a in (force, errors, speeds)]
    assert names[0] == ["steepness 1", "2D", "1D, local depth"]
    assert names[2] == ["2D", "1D, local depth"]
    assert not any("curvature" in name for name in names[1])
    assert len(set(names[1])) == len(names[1]) == 5


def test_a_branch_from_rest_follows_the_square_of_the_current_between_its_points():
    speed = np.array([0.0, 0.9, 1.3, 1.6])
    x, w = filled(speed, -(speed**2))
    assert np.diff(x).max() < 0.4
    assert np.allclose(w, -(x**2))
    assert set(speed) <= set(np.round(x, 12))


def test_the_deepest_point_ends_on_the_unstable_equilibrium_at_the_dynamic_limit():
    speed = np.linspace(0, 2, 5)
    unstable = np.array([-4.0, -3.6, -3.2, -2.8, np.nan])
    lowest = np.array([-0.1, -0.5, -1.5, np.nan, np.nan])
    ends = {"dynamic_squat_speed": 1.25, "squat_speed_2d": 1.8, "squat_sinkage_2d": -2.0}
    columns = {"speed": speed, "unstable": unstable, "lowest": lowest}
    data = xr.Dataset({name: ("speed", row) for name, row in columns.items()} | ends)
    x, w = _deepest(data)
    assert (x[-1], w[-1]) == pytest.approx((1.25, -3.0))
    assert np.isnan(_deepest(data.assign(dynamic_squat_speed=np.nan))[1][-1])


@pytest.fixture(scope="module")
def study(case):
    keys = "sizes=[1.6,0.4]", "distances=[20,40,160]", "accuracy.near=0.32", "tolerance=0.01"
    return sensitivity_study(case("sensitivity", *keys))


def test_two_recommendations_say_what_they_are_off_together(study):
    mesh = study["size_inertia_coefficient"].values[0, 1] / float(study["size_limit"])
    near, far = study["distance_inertia_coefficient"].values[1:]
    error = (1 - mesh) + (1 - near / far)
    said = sensitivity(study)._supxlabel.get_text()
    assert f"together {100 * error:.1f} %" in said
    assert "0.4 m at the hull" in said


def test_a_study_in_which_nothing_is_good_enough_says_so(study):
    said = sensitivity(study.assign_attrs(recommended_size=np.nan))._supxlabel.get_text()
    assert "no size tried" in said
    assert "nan" not in said
    assert "together" not in said
