"""Several runs in one recording: one axis, differences, names."""

from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest
import rerun as rr
import xarray as xr

from squat import records
from squat.replay.overlay import _axis, _drawn, _overlaid, _told, difference, time_view
from squat.replay.panels import draw_all, picture_aspect
from squat.replay.plots import PLOTS, Curve
from squat.replay.recorder import Recorder
from squat.replay.runs import labels, load
from squat.sweeps.folders import job_folder
from tests.replay.conftest import COARSE
from tests.replay.reading import NANOSECOND, scalars


def test_compared_runs_stand_on_one_axis_with_their_difference(record, entities, ship, bare):
    found = entities(record(ship, bare))
    first, other = records.read(ship), records.read(bare)
    for label, data in {"ship": first, "bare": other}.items():
        assert np.array_equal(scalars(found[f"{label}/plots/heave/heave"]), data["heave"].values)
    change = found["bare/differences/heave/heave"]
    common = first["time"].values <= other["time"].values[-1]
    assert change.time == pytest.approx(first["time"].values[common], abs=NANOSECOND)
    there = np.interp(first["time"].values[common], other["time"].values, other["heave"].values)
    assert np.array_equal(scalars(change), there - first["heave"].values[common])


def test_a_run_has_one_colour_where_another_has_no_such_curve_too(record, entities, ship, written):
    both = written("both", "transient", *COARSE, "modes=[heave,pitch]")
    found = entities(record(ship, both))
    assert "ship/plots/pitch/pitch" not in found
    pitch, heave = (
        found[f"both/plots/{name}/{name}"].rows["colors"] for name in ("pitch", "heave")
    )
    assert pitch == heave


@pytest.mark.parametrize(("root", "far"), [(-5.0, False), (-8.0, True), (np.nan, False)])
def test_a_root_far_below_does_not_flatten_the_motion(root, far):
    data = xr.Dataset(
        {"heave": ("time", [-0.1, -1.0]), "stable_root": ((), -0.8), "unstable_root": ((), root)}
    )
    (plot,) = (one for one in PLOTS if one.name == "heave")
    runs = (SimpleNamespace(data=data, label=""),)
    assert [_drawn(curve, plot, runs) for curve in plot.curves] == [True, True, not far]


@pytest.mark.parametrize(("failed", "far"), [(0.4, False), (12.0, True), (np.nan, False)])
def test_a_failed_step_far_above_stands_in_the_title(failed, far):
    data = xr.Dataset(
        {
            "contraction": ("time", [0.30, 0.31]),
            "predicted_contraction": ((), 0.3),
            "failed_contraction": ((), failed),
        }
    )
    (plot,) = (one for one in PLOTS if one.name == "contraction")
    (dot,) = (curve for curve in plot.curves if curve.last)
    runs = (SimpleNamespace(data=data, label=""),)
    assert _drawn(dot, plot, runs) is not far
    assert not far or _told(dot, runs) == "; failed step: 12"


def test_a_run_less_itself_is_nothing(ship, tmp_path):
    copy = tmp_path / "copy.nc"
    copy.write_bytes(ship.read_bytes())
    first, other = load((str(ship), str(copy)))
    clock, values = difference(first, other, Curve("w", lambda data: data["heave"], "w", ""))
    assert np.all(values == 0)
    assert len(clock.time) == first.data.sizes["time"]


def test_counts_are_compared_by_the_steps_they_belong_to(ship):
    (run,) = load((str(ship),))
    time = run.data["time"].values
    coarse = run.data.isel(time=[0, 2, 4]).assign(iterations=("time", [0, 3, 6]))
    first = replace(run, data=run.data.isel(time=slice(0, 5)))
    fine = first.data.assign(iterations=("time", [0, 1, 1, 1, 1]))
    counts = Curve("n", lambda data: data["iterations"], "n", "", whole=True)
    clock, values = difference(replace(first, data=fine), replace(run, data=coarse), counts)
    assert np.array_equal(clock.time, time[:5])
    assert list(values) == [0, 2, 2, 5, 5]


def test_a_panel_of_several_runs_says_which_factor_it_compares(ship, bare):
    runs = load((str(ship), str(bare)))
    with rr.RecordingStream("test") as stream:
        views = draw_all(Recorder(stream), runs)
    titles = [view.name for place in views.values() for view in place]
    assert any(title.startswith("Contraction factor, measured") for title in titles)
    never = [replace(run, data=run.data.assign(contraction=np.nan * run.data.time)) for run in runs]
    with rr.RecordingStream("test") as stream:
        views = draw_all(Recorder(stream), tuple(never))
    titles = [view.name for place in views.values() for view in place]
    assert "Δ Contraction factor: none in common" in titles


def test_names_in_the_legend_are_short_and_have_room_above_the_curves(record, entities, ship, bare):
    found = entities(record(ship, bare))
    assert found["bare/plots/iterations/iterations"].rows["names"] == [["bare"]]
    assert found["bare/differences/iterations/iterations"].rows["names"] == [["bare"]]
    assert found["bare/plots/heave/heave"].rows["names"] == [["bare"]]
    curves = [("a", np.array([0.0, 1.0])), ("b", np.array([0.5]))]
    low, high = _axis(curves, 0.0, above=0.24).range.as_arrow_array().to_pylist()[0]
    assert low <= 0.0
    assert (1.0 - low) / (high - low) <= 1 - 0.24 + 1e-12


def test_a_legend_below_may_cover_level_lines_but_no_motion():
    root, deep = ("root", np.array([-1.0, -1.0])), ("root", np.array([-9.0, -9.0]))
    heave = "w", np.array([-0.1, -1.2, -0.1])
    low, high = _axis([heave, root], 0.0, 0.0, below=0.4).range.as_arrow_array().to_pylist()[0]
    assert (-1.2 - low) / (high - low) >= 0.4 - 1e-12
    there = _axis([heave, deep], 0.0, 0.0, below=0.4)  # the root makes the room
    assert there == _axis([heave, deep], 0.0, 0.0)


def test_a_plot_without_legend_above_has_the_margins_of_the_viewer():
    heave = np.array([-6.5, -0.1])
    assert heave[0] + np.ptp(heave) != heave[1]  # rounding must not count as a range of its own
    assert _axis([("w", heave)], 0.0, above=0.0) is None


@pytest.fixture
def fallen(written):
    """Runs long enough to come near to the unstable root."""
    keys = (*(key for key in COARSE if not key.startswith("time")), "time.periods=1")
    return (
        written("fallen", "transient", *keys),
        written("fallen_too", "transient", *keys, "time.steps_per_period=50"),
    )


def test_roots_that_runs_share_are_drawn_as_those_of_a_single_run(record, entities, fallen):
    together, single = entities(record(*fallen)), entities(record(fallen[0]))
    for name in ("stable_root", "unstable_root"):
        alone = single[f"plots/heave/{name}"].rows
        for run in ("fallen", "fallen_too"):
            here = together[f"{run}/plots/heave/{name}"].rows
            assert (here["names"], here["colors"]) == (alone["names"], alone["colors"])


def test_roots_that_differ_are_left_to_the_parameters(record, entities, fallen, kept):
    found = entities(record(fallen[0], kept))
    drawn = [name for name in found if "/plots/heave/" in name]
    assert sorted(drawn) == ["fallen/plots/heave/heave", "kept/plots/heave/heave"]


def test_a_root_is_near_to_all_runs_or_to_none():
    """Of a run that ends at once it would be far; the motion of the other counts for both."""
    roots = {"stable_root": ((), -0.8), "unstable_root": ((), -6.0)}
    still, moving = (
        SimpleNamespace(data=xr.Dataset({"heave": ("time", heave), **roots}), label="run")
        for heave in ([-0.8, -0.79], [-0.1, -3.0])
    )
    (plot,) = (one for one in PLOTS if one.name == "heave")
    drawn = [
        [_drawn(curve, plot, runs) for curve in plot.curves]
        for runs in ((still, still), (still, moving))
    ]
    assert drawn == [[True, True, False], [True, True, True]]


def test_pictures_in_tabs_have_the_whole_place():
    assert [picture_aspect(3.0, count) for count in (1, 2, 3)] == [3.0, 6.0, 3.0]


def test_a_diagram_whose_axis_has_no_numbers_says_how_long(bare):
    (run,) = load((str(bare),))
    (plot,) = (one for one in PLOTS if one.name == "iterations")
    names = []
    for last in (2.19, 60.0, 479.7):
        times = run.data["time"] * (last / run.steps.time[-1])
        slow = replace(run, data=run.data.assign_coords(time=times))
        recorder = Recorder(rr.RecordingStream("test"))
        names += [str(view.name) for view in _overlaid(plot)(recorder, (slow,))]
    told = ["Iterations of a step; 0 to 2.19 s", "Iterations of a step"]
    assert names == [*told, "Iterations of a step; 0 to 480 s"]


def test_labels_say_what_differs_and_no_more():
    def named(*paths):
        return labels([Path(path) for path in paths])

    assert named("a/run.nc", "b/run.nc") == ["a", "b"]
    assert named("a.nc", "x/b.2.nc") == ["a", "b.2"]
    assert named("a/run.nc") == [""]
    assert named("x/v-1__s-5/run.nc", "x/s-5__v-2/run.nc") == ["v 1", "v 2"]
    assert named("hull.draft--1/run.nc", "hull.draft-2/run.nc") == ["draft -1", "draft 2"]
    assert named("hull.draft-9__x.y-1/r.nc", "hull.draft-8__x.y-1__v-2/r.nc") == [
        "draft 9",
        "draft 8, v 2",
    ]
    assert named("a.l-1/run.nc", "b.l-1/run.nc") == ["a.l-1", "b.l-1"]
    assert named("v-1.nc", "v-2.nc") == ["v-1", "v-2"]
    assert named("a/x/1.nc", "a/y/2.nc", "b/x/2.nc") == ["x/1", "y/2", "x/2"]


def test_runs_in_folders_whose_names_were_cut_are_told_apart_by_their_configurations(
    tmp_path, written
):
    paths = []
    for ratio in (8, 9):
        made = written(f"ratio{ratio}", "piston", f"piston.mass_ratio={ratio}")
        folder = tmp_path / job_folder(f"a.b-{'1' * 200}__piston.mass_ratio-{ratio}")
        folder.mkdir()
        paths.append(str(folder / "piston.nc"))
        Path(paths[-1]).write_bytes(made.read_bytes())
    assert [run.label for run in load(tuple(paths))] == ["mass_ratio 8", "mass_ratio 9"]


def test_a_diagram_of_a_run_without_a_step_says_so(bare):
    (run,) = load((str(bare),))
    (plot,) = (plot for plot in PLOTS if plot.name == "iterations")
    for whole, title in (
        (run.data, "; 0 to 2.19 s"),
        (run.data.isel(time=[0]), ": no step was accepted"),
    ):
        recorder = Recorder(rr.RecordingStream("test"))
        (view,) = _overlaid(plot)(recorder, (replace(run, data=whole),))
        assert str(view.name) == plot.title + title


@pytest.mark.parametrize(
    ("name", "roomy"), [("heave", True), ("iterations", True), ("pitch", False)]
)
def test_a_single_runs_legend_has_room_where_curves_go_to_its_corner(name, roomy):
    (plot,) = (one for one in PLOTS if one.name == name)
    shown = [("curve", np.array([1.0, 9.0, 1.0]))]
    run = SimpleNamespace(span=SimpleNamespace(time=np.array([0.0, 1.0])))
    view = time_view(plot, plot.title, [], shown, (run,))
    assert ("ScalarAxis" in view.properties) == roomy
