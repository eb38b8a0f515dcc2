"""Chosen runs in one picture."""

import numpy as np
import pandas as pd
import pytest
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure

import squat as api
from squat.catalogue import (
    find,
    select,
)
from squat.catalogue.telling import telling
from squat.config.units import unit
from squat.errors import InputError
from squat.figures.compare import CompareCase, draw, write_compare
from squat.figures.labels import axis_label, units_label
from squat.figures.layers import looks
from squat.figures.run_points import draw_points
from tests.catalogue.runs import RATIOS


def test_compared_runs_are_drawn_as_they_are(runs):
    table = select(find([runs]), "kind == 'piston'")
    (axes,) = draw(table, "position", None).axes
    for line, ratio in zip(axes.lines, sorted(RATIOS), strict=True):
        data = api.open_run(runs / f"deep/{ratio}/piston.nc")
        assert np.array_equal(line.get_ydata(), data["position"])
        assert np.array_equal(line.get_xdata(), data["time"])
        assert f"mass_ratio = {ratio:g}" in line.get_label()
    with pytest.raises(InputError, match=r"variable=heave: no run has that; .* as .*position"):
        draw(table, "heave", None)


@pytest.mark.parametrize(
    ("variable", "over", "said"),
    [
        ("position", "piston.mass_ratio", "position is no single number .* over time; .*velocity"),
        ("result.steps", "position", "position is no single number .*result.position_min"),
        ("position", "heave", "^over=heave: no run has that"),
        ("time_step", "piston.mass_ratio", "give result.time_step"),
        ("result.steps", None, "result.steps: one value a run; give over=KEY .*piston.mass_ratio"),
        (
            "result.steps",
            "piston.mass_rati",
            "did you mean piston.mass_ratio.*; give over=KEY.*as pis",
        ),
        ("scheme", None, "scheme: one value a run; give over=KEY"),
        (
            "result.step",
            None,
            "result.step: no run has that .did you mean result.steps..; .* as result",
        ),
    ],
)
def test_what_cannot_be_compared_is_told_apart_from_what_is_not_there(runs, variable, over, said):
    table = select(find([runs]), "kind == 'piston'")
    with pytest.raises(InputError, match=said):
        draw(table, variable, over)


@pytest.mark.parametrize(
    ("held", "written"),
    [
        ("1", "-"),
        ("m", "m"),
        ("m2", "m²"),
        ("m s-1", "m/s"),
        ("m s-2", "m/s²"),
        ("J s m-1", "J s/m"),
        ("s-1", "1/s"),
        ("W m-2 s-1", "W/(m² s)"),
        ("per cent %", "per cent %"),
    ],
)
def test_units_are_written_as_in_all_figures(held, written):
    assert units_label(held) == written


def test_units_stay_whole_at_the_end_of_long_labels(runs):
    table = select(find([runs]), "kind == 'piston'")
    long = "velocity of the piston along its long axis, positive up"
    assert axis_label(long, "m s-1").splitlines()[-1].endswith("[m/s]")
    figure = draw(table, "position", None)
    (axes,) = figure.axes
    axes.set_ylabel(axis_label(long + ", seen by one who stands still on the bank", "kg m-2 s-2"))
    FigureCanvasAgg(figure).draw()
    box = axes.yaxis.label.get_window_extent()
    assert figure.bbox.contains(box.x0, box.y0)
    assert figure.bbox.contains(box.x1, box.y1)


def test_runs_that_failed_are_open_markers_beside_the_line_of_the_others(runs):
    table = select(find([runs]), "kind == 'piston'")
    (axes,) = draw(table, "result.position_last", "piston.mass_ratio").axes
    done, failed = axes.lines
    assert list(done.get_xdata()) == [0.5, 0.9]
    assert (done.get_linestyle(), done.get_markerfacecolor()) == ("-", done.get_color())
    assert list(failed.get_xdata()) == [2.0]
    assert (failed.get_linestyle(), failed.get_markerfacecolor()) == ("None", "none")
    assert failed.get_color() == done.get_color()
    assert failed.get_label() == "diverged"
    (axes,) = draw(table[table["status"] == "diverged"], "result.steps", "piston.mass_ratio").axes
    assert axes.get_legend_handles_labels()[1] == ["diverged"]


def test_axes_have_the_units_that_are_known(runs):
    table = select(find([runs]), "kind == 'piston'")
    labels = []
    for variable in ("position_last", "predicted_contraction", "iterations_mean", "steps"):
        (axes,) = draw(table, f"result.{variable}", "time.periods", unit).axes
        labels.append(axes.get_ylabel())
    assert labels == [
        "position last [m]",
        "predicted contraction [-]",
        "iterations mean [-]",
        "steps",
    ]
    assert axes.get_xlabel() == "time.periods"
    (axes,) = draw(table, "result.position_last", "piston.length", unit).axes
    assert axes.get_xlabel() == "piston.length [m]"


def test_an_entry_of_a_matrix_has_its_own_units(tmp_path):
    run = api.run("added_mass", "mesh=coarse", "accuracy=coarse")
    run.to_netcdf(tmp_path / "added_mass.nc", engine="h5netcdf")
    labels = []
    for mode in ("heave", "pitch"):
        variable = f"result.added_mass_{mode}"
        (axes,) = draw(find([tmp_path]), variable, "hull.draft", unit).axes
        labels.append(axes.get_ylabel())
    assert labels == ["added mass heave [kg/m]", "added mass pitch [kg m]"]


def test_a_run_of_one_point_is_seen(tmp_path):
    keys = "mesh=coarse", "accuracy.near=0.4", "time.periods=0.05", "current=1"
    for name in ("printed", "printed_standard"):
        run = api.run("transient", *keys, f"coupling={name}")
        run.to_netcdf(tmp_path / f"{name}.nc", engine="h5netcdf")
    (axes,) = draw(find([tmp_path]), "heave", None).axes
    drawn = {line.get_label(): (len(line.get_xdata()), line.get_marker()) for line in axes.lines}
    assert drawn["coupling = printed_standard: diverged"] == (1, "o")
    assert drawn["coupling = printed: completed"][1] == "None"


def test_no_two_of_twenty_lines_are_alike_and_lines_on_each_other_differ_in_colour():
    x = np.linspace(0, 1, 50)
    slopes = [1, 2, 3, 3, 4, 3, 5, 3, 6, 7, 8, 8, 9, 10, 11, 12, 13, 3, 14, 15]
    given = looks([np.stack([x, slope * x]) for slope in slopes])
    assert len({(look["color"], look["ls"]) for look in given}) == len(slopes)
    together = [look["color"] for look, slope in zip(given, slopes, strict=True) if slope == 3]
    assert len(set(together)) == len(together)


def test_a_point_on_a_line_makes_neither_of_them_wider():
    line, point = np.stack([np.linspace(0, 1, 50)] * 2), np.zeros((2, 1))
    assert len({look["lw"] for look in looks([line, point])}) == 1


def test_runs_that_coincide_are_all_seen(runs):
    row = find([runs / "deep/0.5"])
    table = pd.concat([row] * 4, ignore_index=True).assign(current=range(4))
    (axes,) = draw(table, "position", None).axes
    widths = [line.get_linewidth() for line in axes.lines]
    assert widths == sorted(set(widths), reverse=True)
    dashes = [line.get_linestyle() for line in axes.lines]
    assert dashes[0] != dashes[1]
    lost = find([runs / "deep/2.0"])
    table = pd.concat([lost] * 3, ignore_index=True).assign(current=range(3))
    (axes,) = draw(table, "position", None).axes
    sizes = [line.get_markersize() for line in axes.lines]
    assert sizes == sorted(set(sizes), reverse=True)
    assert {line.get_markerfacecolor() for line in axes.lines} == {"none"}


def test_runs_that_differ_are_equally_thick(runs):
    table = select(find([runs]), "kind == 'piston' and status != 'diverged'")
    (axes,) = draw(table, "position", None).axes
    assert len(axes.lines) == 2
    assert len({(line.get_linewidth(), line.get_linestyle()) for line in axes.lines}) == 1
    both = pd.concat([table, table.iloc[:1]], ignore_index=True).assign(current=range(3))
    (axes,) = draw(both, "position", None).axes
    widths = [line.get_linewidth() for line in axes.lines]
    assert widths[0] > widths[1] == widths[2]
    assert axes.get_title(loc="right") == "a thick line lies under others"
    for apart in (("position", None), ("result.position_last", "piston.mass_ratio")):
        (axes,) = draw(select(find([runs]), "kind == 'piston'"), *apart).axes
        assert axes.get_title(loc="right") == ""


def test_a_key_that_some_runs_lack_is_named_only_where_nothing_else_tells():
    table = pd.DataFrame(
        {"modes": ['["heave"]', '["heave"]', None], "hull.draft": [8.0, 9.0, 10.0], "kind": "x"}
    )
    assert telling(table) == ["hull.draft"]
    assert telling(table.assign(**{"hull.draft": [8.0, 9.0, 9.0]})) == ["hull.draft", "modes"]


def test_labels_hold_all_that_differs_not_only_what_tells_the_runs_apart(runs):
    table = pd.DataFrame(
        {
            "file": sorted(map(str, runs.glob("deep/*/piston.nc"))),
            "kind": "piston",
            "status": "converged",
            "current": [2.0, 2.0, 1.5],
            "hull.draft": [10.0, 11.0, 11.0],
            "hull.length": [40.0, 40.0, 45.0],
            "time.periods": [3.0, 3.0, 4.0],
        }
    )
    (axes,) = draw(table, "position", None).axes
    assert {line.get_label() for line in axes.lines} == {
        "current = 2, draft = 10, length = 40",
        "current = 2, draft = 11, length = 40",
        "current = 1.5, draft = 11, length = 45",
    }
    many = table.assign(**{f"key{n}": [0, 1, n] for n in range(2, 8)})
    (axes,) = draw(many, "position", None).axes
    assert all(line.get_label().endswith(", ...") for line in axes.lines)
    assert all(line.get_label().count(" = ") == 6 for line in axes.lines)


def test_keys_that_vary_along_a_line_are_said_beside_it():
    table = pd.DataFrame(
        {
            "current": [1.0, 2.0, 1.0, 2.0],
            "criterion.iterations": [200, 2000, 200, 2000],
            "hull.draft": [10.0, 10.0, 11.0, 11.0],
            "hull.length": [40.0, 40.0, 45.0, 45.0],
            "clearance": [5.0, 6.0, 7.0, 8.0],
            "status": "completed",
            "kind": "x",
        }
    )
    axes = Figure().add_subplot()
    said = draw_points(axes, table, "clearance", "current", lambda kind, key: None)
    assert said == "along a line vary too: criterion.iterations"
    labels = [line.get_label() for line in axes.lines]
    assert labels == ["draft = 10, length = 40", "draft = 11, length = 45"]
    one = table[table["hull.draft"] == 10.0]
    assert said == draw_points(axes, one, "clearance", "current", lambda kind, key: None)
    steady = one.drop(columns="criterion.iterations")
    assert draw_points(axes, steady, "clearance", "current", lambda kind, key: None) == ""


def test_dots_that_lie_on_each_other_are_all_seen():
    table = pd.DataFrame(
        {
            "scheme": ["a", "a", "b", "b", "c", "c"],
            "current": [1.0, 2.0] * 3,
            "clearance": [5.0, 6.0, 5.0, 6.0, 9.0, 7.0],
            "status": "completed",
            "kind": "x",
        }
    )
    axes = Figure().add_subplot()
    draw_points(axes, table, "clearance", "current", lambda kind, key: None)
    sizes = [line.get_markersize() for line in axes.lines]
    assert sizes[0] > sizes[1] == sizes[2]
    names = table.assign(current=["low", "high"] * 3)
    axes = Figure().add_subplot()
    draw_points(axes, names, "clearance", "current", lambda kind, key: None)
    assert [line.get_linestyle() for line in axes.lines] == ["None"] * 3


def test_more_lines_than_looks_there_are_begin_anew():
    found = looks([np.array([[0.0, 1.0], [n, n + 1.0]]) for n in range(30)])
    assert len(found) == 30
    assert len({(look["color"], str(look["ls"])) for look in found}) == 21


def test_runs_without_the_variable_are_skipped_and_counted(runs, tmp_path, caplog):
    out = tmp_path / "compare.png"
    write_compare(CompareCase(runs=str(runs), where="", variable=None, over=None), out)
    assert out.exists()
    (axes,) = draw(find([runs]), "position", None).axes
    assert len(axes.lines) == len(RATIOS)
    draw(find([runs]), "result.position_last", "piston.mass_ratio")
    assert [record.getMessage() for record in caplog.records] == [
        "1 of 4 runs left out: without position",
        "1 of 4 runs left out: without position",
        "1 of 4 runs left out: without result.position_last or piston.mass_ratio",
    ]


def test_a_legend_names_the_choice_rather_than_its_parts(runs):
    table = pd.DataFrame(
        {
            "file": sorted(map(str, runs.glob("deep/*/piston.nc"))),
            "kind": "piston",
            "status": "converged",
            "coupling.accelerator.name": ["none", "none", "iqn_ils"],
            "coupling.scheme": ["standard", "corrected", "consistent"],
            "coupling.name": ["printed_standard", "printed", "consistent_quasi_newton"],
            "hull.length": [40.0, 30.0, 20.0],
            "hull.shape": ["rectangle", "lewis", "v"],
        }
    )
    (axes,) = draw(table, "position", None).axes
    names = zip(table["coupling.name"], table["hull.shape"], strict=True)
    labels = {line.get_label() for line in axes.lines}
    assert labels == {f"coupling = {coupling}, hull = {hull}" for coupling, hull in names}
    (axes,) = draw(table.drop(columns="coupling.name").iloc[:2], "position", None).axes
    assert [line.get_label() for line in axes.lines] == [
        "hull = lewis, scheme = corrected",
        "hull = rectangle, scheme = standard",
    ]


def test_the_command_writes_both_pictures(runs, squat, tmp_path):
    done = squat("task=compare", f"runs={runs / 'deep'}")
    assert done.returncode == 0, done.stderr
    assert (tmp_path / "compare.png").read_bytes().startswith(b"\x89PNG")
    assert "<svg" in (tmp_path / "compare.svg").read_text()
