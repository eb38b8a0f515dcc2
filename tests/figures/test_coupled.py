"""Pictures of coupled runs."""

import numpy as np
import pytest
from matplotlib.backends.backend_agg import FigureCanvasAgg

from squat import records, transient
from squat.config import compose, validate
from squat.errors import InputError
from squat.figures.energy import energy_audit
from squat.figures.labels import of_ships
from squat.figures.transient import fig11, fig12, fig13
from squat.stability.equilibria import OneDimensionalModel


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


@pytest.mark.parametrize("figure", [fig13, energy_audit])
def test_energies_of_a_run_without_an_accepted_step_are_words(sailed, figure):
    run = sailed("current=3", "coupling=printed_standard")
    drawn = figure(run)
    said = [text.get_text() for axes in drawn.axes for text in axes.texts]
    said += [text.get_text() for one in _legends(drawn) for text in one.get_texts()]
    assert any("no step was accepted:\nthe first diverged" in text for text in said)
    for axes in drawn.axes:
        assert (list(axes.get_xticks()), list(axes.get_yticks())) == ([], [])


def _legends(figure):
    own = [axes.get_legend() for axes in figure.axes]
    return [legend for legend in [*figure.legends, *own] if legend is not None]


def test_roots_of_eq_27_are_named_where_they_are_and_for_the_box_that_they_are_of(case, sailed):
    slow, fast = sailed("current=1"), sailed("current=3")
    names = [text.get_text() for text in fig11(fast).legends[0].get_texts()]
    assert names == ["heave $w$"]
    ship = case("transient")
    limit = OneDimensionalModel(ship.hull, ship.channel, ship.water).squat_speed()
    for figure in (fig11(fast, slow), fig11(slow, fast)):
        names = [text.get_text() for text in figure.legends[0].get_texts()]
        assert names == ["heave $w$", "stable root, Eq. (27)"]
        ends = {axes.get_title(loc="left").partition(": ")[2] for axes in figure.axes}
        above = f"completed; no root of Eq. (27) above {limit.speed:.3f} m/s"
        far = f"completed\nunstable root far below, {float(slow['unstable_root']):.2f} m"
        assert ends == {"", far, above}
    raked = sailed("current=1", "hull=lewis")
    names = [text.get_text() for text in fig11(raked).legends[0].get_texts()]
    assert names[1] == "stable root of Eq. (27), a box of this length and draft"


def test_long_titles_are_broken_before_the_picture_ends(sailed):
    runs = [sailed("current=3", f"coupling={name}") for name in ("printed", "consistent")]
    long = [run.assign_attrs(status="a status of many words, to be told whole") for run in runs]
    figure = fig11(*long)
    FigureCanvasAgg(figure).draw()
    for axes in figure.axes:
        box = axes._left_title.get_window_extent()
        assert not axes.get_title(loc="left") or figure.bbox.contains(box.x1, box.y1)


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
    assert [title.partition("\n")[0] for title in titles] == [
        '$V_\\infty$ = 1 m/s, modes = ["heave"], initial_pitch = 0: completed',
        '$V_\\infty$ = 2 m/s, modes = ["heave"], initial_pitch = 0: completed',
        '$V_\\infty$ = 2 m/s, modes = ["heave", "pitch"], initial_pitch = 0.001: completed',
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


def test_pressure_that_leaves_the_frame_is_said_to_be_singular_and_1d_to_be_of_a_box(sailed):
    smooth, box = sailed("current=1", "hull=half_ellipse"), sailed("current=1")
    under = box["hull_z"] == box["hull_z"].min()
    corner = under & (box["hull_x"] == 0.0)
    assert int(corner.sum()) == 1
    sharp = box.assign(hull_pressure=box["hull_pressure"] - 1e6 * corner)
    uniform = "1D, uniform under the hull"
    for run, told in (
        (smooth, ["2D", f"{uniform}, a box of this draft"]),
        (sharp, ["2D (the corners are singular)", uniform]),
    ):
        (axes,) = fig12(run).axes
        assert [text.get_text() for text in axes.get_legend().get_texts()] == told


def test_pressure_of_a_ship_on_the_bottom_is_said_to_be_noise(sailed):
    sound = sailed("current=1")
    for status, told in (("completed", False), ("grounded", True)):
        (axes,) = fig12(sound.assign_attrs(status=status)).axes
        assert axes.get_title().endswith("grounded: noise of the mesh") == told


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
