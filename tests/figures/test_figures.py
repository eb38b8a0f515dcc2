"""What a reader would complain of: labels over lines, titles cut off."""

import json
import math
from inspect import signature
from itertools import combinations

import numpy as np
import pytest
import xarray as xr
from matplotlib.backends.backend_agg import FigureCanvasAgg

from squat import records, transient
from squat.cli.main import main
from squat.cli.tasks import TASKS
from squat.config import compose, validate
from squat.errors import InputError
from squat.figures.added_mass import fig7
from squat.figures.domain import fig3, fig8
from squat.figures.energy import energy_audit
from squat.figures.equilibria import fig10
from squat.figures.labels import of_ships
from squat.figures.limits import basins, limits
from squat.figures.mesh import fig6
from squat.figures.stability import phase_portrait, potential
from squat.figures.transient import fig11, fig12
from squat.figures.trim import filled
from squat.figures.uneven import uneven_bottom
from squat.figures.write import FIGURES, FigureCase, catalogue
from squat.fluid.run import run as added_mass
from squat.mesh.run import run as mesh
from squat.records.bottom_kinds import UNEVEN_BOTTOM
from squat.stability.equilibria import OneDimensionalModel
from squat.stability.portrait import run as stability
from squat.stability.run import run as equilibria

DEEP = "channel.bottom=[[-10,0],[10,4],[30,4],[60,-15]]"


@pytest.mark.parametrize("hull", ["rectangle", "lewis"])
def test_labels_of_isovalues_stay_apart_and_off_the_hull(case, hull):
    data = added_mass(case("added_mass", f"hull={hull}", "mesh=coarse"))
    faces = data["face_node"].values
    sides = np.sort(faces[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2), axis=1)
    unique, count = np.unique(sides, axis=0, return_counts=True)
    rim = np.unique(unique[count == 1])
    rim = np.column_stack([data["node_x"][rim], data["node_z"][rim]])
    for axes in fig7(data).axes:
        places = [np.array(text.get_position()) for text in axes.texts]
        assert len(places) > 4
        assert all(np.linalg.norm(rim - place, axis=1).min() > 1 for place in places)
        assert all(np.linalg.norm(a - b) > 1 for a, b in combinations(places, 2))


BARGE = ("hull.length=110.0", "hull.draft=3.2", "channel.depth=4.5", "channel.upstream=110.0")


def test_isovalues_under_a_long_hull_have_their_numbers(case):
    data = added_mass(case("added_mass", "mesh=coarse", "accuracy.near=0.4", *BARGE))
    for axes in fig7(data).axes:
        assert sum(0 < text.get_position()[0] < 110 for text in axes.texts) > 4
        assert axes.xaxis.get_tick_params()["labelbottom"]


SLAB = ("hull.length=190.0", "hull.draft=10.5", "channel.depth=13.0", "channel.upstream=190.0")


@pytest.mark.parametrize("more", [("hull=fig7", "channel=fig7"), SLAB])
def test_numbers_of_isolines_are_whole_and_read_from_one_side(case, more):
    figure = fig7(added_mass(case("added_mass", "mesh=coarse", *more)))
    FigureCanvasAgg(figure).draw()
    for axes in figure.axes:
        boxes = [text.get_window_extent() for text in axes.texts if "×" not in text.get_text()]
        assert len(boxes) > 8
        assert all(axes.bbox.y0 < box.y0 and box.y1 < axes.bbox.y1 for box in boxes)
        rim = [axes.transData.transform(line.get_xydata()) for line in axes.lines]
        rim = np.vstack([np.linspace(*edge, 20) for edge in rim])
        for box in boxes:
            inside = (rim > (box.x0, box.y0)) & (rim < (box.x1, box.y1))
            assert not inside.all(axis=1).any()
        for text in axes.texts:
            assert (text.get_rotation() + 80) % 360 < 180
            assert text.get_text().strip() not in {"6", "9", "\N{MINUS SIGN}6", "\N{MINUS SIGN}9"}


@pytest.mark.parametrize("more", [("hull=curve",), BARGE])
def test_no_label_of_a_dimension_crosses_hull_or_bottom(case, more):
    figure = fig8(mesh(case("mesh", "mesh=coarse", *more)))
    FigureCanvasAgg(figure).draw()
    (axes,) = figure.axes
    labels = [text for text in axes.texts if "=" in text.get_text()]
    assert len(labels) == 6
    for text in labels:
        box = text.get_window_extent().padded(-1)
        for line in axes.lines[:-1]:
            points = axes.transData.transform(line.get_xydata())
            steps = np.linspace(points[:-1], points[1:], 50).reshape(-1, 2)
            assert not any(box.contains(x, y) for x, y in steps)


@pytest.mark.parametrize("draw", [fig3, fig6, fig8])
def test_heights_of_long_shallow_channels_are_stretched_and_a_note_says_so(case, draw):
    wide = draw(mesh(case("mesh", "mesh=coarse", *BARGE))).axes[0]
    assert wide.get_aspect() == round((110 + 110 + 60) / 4.5 / 8)
    assert f"heights × {wide.get_aspect():g}" in [text.get_text() for text in wide.texts]
    plain = draw(mesh(case("mesh", "mesh=coarse"))).axes[0]
    assert plain.get_aspect() == 1
    assert not any("heights" in text.get_text() for text in plain.texts)


@pytest.mark.parametrize("draw", [fig3, fig8])
def test_nothing_is_cut_off_over_a_deep_bottom(case, draw):
    figure = draw(mesh(case("mesh", "mesh=coarse", DEEP, "position.heave=0.0")))
    FigureCanvasAgg(figure).draw()
    (axes,) = figure.axes
    for text in (axes.title, axes.xaxis.label, axes.yaxis.label):
        box = text.get_window_extent()
        assert figure.bbox.contains(box.x0, box.y0)
        assert figure.bbox.contains(box.x1, box.y1)


def test_energy_audit_says_all_it_shows(case, tmp_path):
    """Titles, axes and legends inside of the picture, both balances of every run in it."""
    keys = ["mesh=coarse", "accuracy.near=0.4", "time.periods=0.05", "current=2.0"]
    kept = ["force=variational", "model=curves", "coupling=energy_momentum"]
    runs = []
    for number, more in enumerate(([], kept)):
        config = compose("transient", *keys, *more)
        records.save(
            transient.run(case("transient", *keys, *more)).dataset,
            tmp_path / f"{number}.nc",
            config,
            0.0,
        )
        runs.append(records.read(tmp_path / f"{number}.nc"))
    figure = energy_audit(*runs)
    FigureCanvasAgg(figure).draw()
    for axes in figure.axes:
        texts = axes.title, axes.xaxis.label, axes.yaxis.label, axes.get_legend()
        for box in (text.get_window_extent() for text in texts):
            assert figure.bbox.contains(box.x0, box.y0)
            assert figure.bbox.contains(box.x1, box.y1)
    assert len(figure.axes[-1].lines) == 4


def test_energy_audit_names_runs_by_what_differs(sailed):
    deep, shallow = sailed("current=2"), sailed("current=2", "hull.draft=8")
    figure = energy_audit(deep, shallow)
    names = [text.get_text() for text in figure.axes[-1].get_legend().get_texts()]
    assert names == ["draft = 10", "draft = 8"]
    assert figure.get_suptitle() == "Energy since $t$ = 0, 2 runs"
    assert [axes.get_title().partition("\n")[2] for axes in figure.axes[:2]] == [
        "draft = 10, first of 2 runs"
    ] * 2
    assert "printed" in energy_audit(deep).get_suptitle()


def test_pressure_that_a_run_does_not_hold_is_not_drawn(case):
    keys = "mesh=coarse", "accuracy.near=0.4", "time.periods=0.05", "model=curves"
    run = transient.run(case("transient", *keys, "force=variational", "coupling=energy_momentum"))
    with pytest.raises(InputError, match="model=curves has no pressure"):
        fig12(run.dataset)


@pytest.fixture(scope="module")
def sailed(tmp_path_factory):
    """The record of a short run."""
    folder = tmp_path_factory.mktemp("sailed")

    def run(*more):
        keys = ["mesh=coarse", "accuracy.near=0.4", "time.periods=0.05", *more]
        path = folder / f"{len(list(folder.iterdir()))}.nc"
        valid = validate(compose("transient", *keys))
        records.save(transient.run(valid.case).dataset, path, valid.config, 0.0)
        return records.read(path)

    return run


def test_a_run_without_an_accepted_step_says_so(sailed):
    run = sailed("current=3", "coupling=printed_standard")
    assert run.sizes["time"] == 1
    left, right = fig11(run).axes
    assert left.get_title(loc="left").startswith("$V_\\infty$ = 3 m/s: diverged; no root of Eq.")
    assert [text.get_text() for text in right.texts] == [
        "no step was accepted:\nthe first diverged"
    ]


def test_roots_of_eq_27_are_named_where_they_are_and_for_the_box_that_they_are_of(case, sailed):
    slow, fast = sailed("current=1"), sailed("current=3")
    names = [text.get_text() for text in fig11(fast).legends[0].get_texts()]
    assert names == ["heave $w$"]
    ship = case("transient")
    limit = OneDimensionalModel(ship.hull, ship.channel, ship.water).squat_speed()
    for figure in (fig11(fast, slow), fig11(slow, fast)):
        names = [text.get_text() for text in figure.legends[0].get_texts()]
        assert names == ["heave $w$", "stable root, Eq. (27)", "unstable root, Eq. (27)"]
        ends = {axes.get_title(loc="left").partition(": ")[2] for axes in figure.axes}
        above = f"completed; no root of Eq. (27) above {limit.speed:.3f} m/s"
        assert ends == {"", "completed", above}
    raked = sailed("current=1", "hull=lewis")
    names = [text.get_text() for text in fig11(raked).legends[0].get_texts()]
    assert names[1] == "stable root of Eq. (27), a box of this length and draft"


def test_time_in_seconds_is_above_the_phase(sailed):
    run = sailed("current=1")
    figure = fig11(run)
    FigureCanvasAgg(figure).draw()
    (seconds,) = figure.axes[0].child_axes
    assert seconds.get_xlim()[1] == pytest.approx(float(run["time"][-1]))
    assert seconds.get_xticklabels()[0].get_text() == "0 s"


def test_pitch_has_a_row_and_titles_tell_what_differs(sailed):
    one, two = sailed("current=1"), sailed("current=2")
    both = sailed("current=2", "modes=[heave,pitch]", "initial_pitch=0.001")
    figure = fig11(one, two, both)
    FigureCanvasAgg(figure).draw()
    titles = [title for axes in figure.axes if (title := axes.get_title(loc="left"))]
    assert titles == [
        '$V_\\infty$ = 1 m/s, modes = ["heave"]: completed',
        '$V_\\infty$ = 2 m/s, modes = ["heave"]: completed',
        '$V_\\infty$ = 2 m/s, modes = ["heave", "pitch"]: completed',
    ]
    (pitch,) = [axes for axes in figure.axes if axes.get_ylabel().startswith("pitch")]
    assert np.array_equal(pitch.lines[0].get_ydata(), np.rad2deg(both["pitch"]))
    assert len(figure.axes) == 7
    assert of_ships([one, two]) == ["$V_\\infty$ = 1 m/s", "$V_\\infty$ = 2 m/s"]
    printed = sailed("current=2", "coupling=consistent_quasi_newton")
    assert of_ships([two, printed]) == ["coupling = printed", "coupling = consistent_quasi_newton"]
    assert of_ships([two]) == ["$V_\\infty$ = 2 m/s"]


def test_the_1d_pressure_ends_at_bow_and_stern(sailed):
    (axes,) = fig12(sailed("current=1")).axes
    assert axes.lines[1].get_label().startswith("1D")
    assert np.allclose(axes.lines[1].get_xdata(), [0, 40])


def test_a_run_of_many_periods_is_drawn_whole(sailed):
    short, long = sailed("current=1"), sailed("current=1", "time.periods=0.1")
    far = long.assign_coords(phase=long["phase"] * 100)
    figure = fig11(short, far)
    assert {axes.get_xlim() for axes in figure.axes} == {(0.0, float(far["phase"][-1]))}
    ends = {round(axes.get_xlim()[1], 9) for axes in fig11(sailed("current=1")).axes}
    assert ends == {round(float(short["phase"][-1]), 9)}


def test_a_raised_stern_is_part_of_the_underside(sailed):
    """Drawn from bow to stern; and what pitch moves has its own depth of still water."""
    points = "hull.points=[[0,0],[0,-10],[30,-10],[40,-4],[40,0]]"
    run = sailed("current=1", "hull=polygon", points)
    x = fig12(run).axes[0].lines[0].get_xdata()
    assert (x.min(), x.max()) == (0.0, 40.0)
    level = run.assign(
        hull_pressure=1000 * 9.81 * (20 - run["hull_z"]).expand_dims(time=run["time"]),
        heave=run["heave"] * 0,
    )
    assert np.abs(fig12(level).axes[0].lines[0].get_ydata()).max() < 1e-9
    turned = level.assign(pitch=run["pitch"] * 0 + 0.01)
    stern = fig12(turned).axes[0].lines[0].get_ydata()[-1] * 1000
    assert stern == pytest.approx(1000 * 9.81 * 0.01 * (40 - float(run["center"][0])), rel=0.02)


@pytest.mark.parametrize(("draft", "count"), [(10.0, 1), (9.0, 0)])
def test_table_7_is_drawn_beside_its_own_ship_alone(case, draft, count):
    keys = "equilibria", f"hull.draft={draft}"
    data = equilibria(case(*keys)).assign_attrs(config=json.dumps(compose(*keys)))
    figure = fig10(data)
    names = [text.get_text() for text in figure.legends[0].get_texts()]
    assert names.count("Table 7, printed") == count


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
    assert len(names[1]) == 4


def test_a_branch_from_rest_follows_the_square_of_the_current_between_its_points():
    speed = np.array([0.0, 0.9, 1.3, 1.6])
    x, w = filled(speed, -(speed**2))
    assert np.diff(x).max() < 0.4
    assert np.allclose(w, -(x**2))
    assert set(speed) <= set(np.round(x, 12))
