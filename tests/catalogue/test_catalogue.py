"""Runs are found wherever they lie, told apart by what differs, filtered, sorted, compared."""

import json

import numpy as np
import pandas as pd
import pytest
import xarray as xr
from matplotlib.backends.backend_agg import FigureCanvasAgg

import squat as api
from squat.catalogue import (
    CatalogueCase,
    DifferenceCase,
    columns,
    find,
    places,
    select,
    varying,
    write_catalogue,
    write_difference,
)
from squat.catalogue.difference import difference
from squat.config import compose, validate
from squat.config.units import unit
from squat.errors import InputError
from squat.figures.compare import CompareCase, _axis, draw, write_compare
from squat.figures.labels import telling

RATIOS = (0.5, 2.0, 0.9)


@pytest.fixture(scope="module")
def runs(tmp_path_factory):
    folder = tmp_path_factory.mktemp("runs")
    for ratio in RATIOS:
        run = api.run("piston", "scheme=standard", "time.periods=0.5", f"piston.mass_ratio={ratio}")
        (folder / f"deep/{ratio}").mkdir(parents=True)
        run.to_netcdf(folder / f"deep/{ratio}/piston.nc", engine="h5netcdf")
    api.run("equilibria").to_netcdf(folder / "roots.nc", engine="h5netcdf")
    return folder


def test_every_run_has_a_row_with_configuration_status_and_figures(runs):
    table = find([runs])
    assert sorted(table["kind"]) == ["equilibria", *["piston"] * 3]
    for row in table[table["kind"] == "piston"].to_dict("records"):
        data = api.open_run(row["file"])
        assert row["status"] == data.attrs["status"]
        assert row["piston.mass_ratio"] == json.loads(data.attrs["config"])["piston"]["mass_ratio"]
        assert row["result.position_last"] == data["position"].values[-1]
        assert row["result.predicted_contraction"] == float(data["predicted_contraction"])
        assert row["result.steps"] == data.sizes["time"] - 1


def test_what_varies_is_what_differs_and_nothing_else(runs):
    table = select(find([runs]), "kind == 'piston'")
    keys = [name for name in varying(table) if not name.startswith("result.")]
    assert keys == ["piston.mass_ratio"]


def test_conditions_take_dotted_names_and_order_is_as_asked(runs):
    table = select(find([runs]), "piston.mass_ratio < 1", ["-piston.mass_ratio"])
    assert list(table["piston.mass_ratio"]) == [0.9, 0.5]
    lost = select(find([runs]), "status == 'diverged' and scheme == \"standard\"")
    assert list(lost["piston.mass_ratio"]) == [2.0]
    assert len(select(find([runs]), "kind == 'piston.mass_ratio'")) == 0


def test_a_name_alone_is_a_list_of_one(runs, tmp_path, capsys):
    for name, ratios in (("piston.mass_ratio", [0.5, 0.9, 2.0]), ("-piston.mass_ratio", [2, 0.9])):
        found = api.find_runs(runs, "kind == 'piston'", sort=name)
        assert list(found["piston.mass_ratio"])[: len(ratios)] == ratios
    case = validate(
        compose("catalogue", f"runs={runs}", "sort=-piston.mass_ratio", "columns=status")
    ).case
    write_catalogue(case, tmp_path / "c.parquet")
    assert capsys.readouterr().out.split()[:3] == ["status", "diverged", "converged"]


def test_a_column_that_no_run_has_leaves_no_table_behind(runs, tmp_path):
    case = validate(compose("catalogue", f"runs={runs}", "columns=speed")).case
    with pytest.raises(InputError, match="columns=speed: no run has it"):
        write_catalogue(case, tmp_path / "c.parquet")
    assert list(tmp_path.iterdir()) == []


def test_a_condition_on_what_some_runs_lack_leaves_these_out(runs):
    assert len(select(find([runs]), "scheme.str.contains('stand')")) == len(RATIOS)


def test_rows_are_in_the_order_of_their_numbers_and_hidden_folders_are_not_searched(tmp_path):
    numbers = (1.0, 2.0, 2.25, 2.5, 10.0)
    for number in numbers:
        run = api.run("piston", "time.periods=0.1", f"piston.mass_ratio={number}")
        for folder in (tmp_path / f"ratio-{number:g}", tmp_path / f".venv/{number:g}"):
            folder.mkdir(parents=True)
            run.to_netcdf(folder / "piston.nc", engine="h5netcdf")
    assert tuple(select(find([tmp_path]))["piston.mass_ratio"]) == numbers
    assert len(find([tmp_path / ".venv"])) == len(numbers)


@pytest.mark.parametrize(
    ("where", "sort", "message"),
    [
        (
            "nonsense > 1",
            [],
            r"where=nonsense > 1: nonsense is no column .*; give one of file, kin",
        ),
        (
            "piston.mas > 1",
            [],
            r": piston.mas is no column .*, piston.mass_ratio, ",
        ),
        ("`no such` > 1 and kind == 'x y'", [], r": no such is no column "),
        ("kind == piston", [], r": text is quoted; give kind == 'piston'$"),
        ("scheme == standard", [], r": standard is no column \(text is quoted, as in 'status == "),
        ("piston.mas_ratio > 1", [], r"mas_ratio is no column; did you mean piston.mass_ratio\?"),
        ("`no` == 1", [], r": no is no column .*; the file of squat task=catalogue has all"),
        ("time.dt == 1", [], r": time.dt is no column .*; give one of time.periods, time.\w+$"),
        ("status = 'a=b'", [], r"where=status = 'a=b': = compares nothing; give =="),
        ("piston.mass_ratio", [], r"where=piston.mass_ratio: a value, no condition; give a cond"),
        ("status", [], r"where=status: a value, no condition; give a condition like"),
        ("kind ==", [], r"where=kind ==: invalid syntax"),
        ("kind.isin(['piston']) and status >", [], r": invalid syntax"),
        ("", "mass_ratio", r"sort=mass_ratio: no run has it; give piston.mass_ratio"),
        ("", ["mass_ratio"], r"sort=mass_ratio: no run has it; give piston.mass_ratio"),
    ],
)
def test_what_no_run_has_is_named(runs, where, sort, message):
    with pytest.raises(InputError, match=message):
        select(find([runs]), where, sort)


def test_of_files_without_choices_the_key_that_names_one_is_offered(runs):
    older = find([runs]).drop(columns="accelerator")
    with pytest.raises(InputError, match=r"or is no column; did you mean accelerator.name\?"):
        select(older, "accelerator == 'none'")


def test_foreign_and_broken_files_are_passed_over(runs, tmp_path, caplog):
    xr.Dataset({"a": ("x", np.arange(3.0))}).to_netcdf(tmp_path / "a.nc", engine="h5netcdf")
    (tmp_path / "broken.nc").write_bytes((runs / "roots.nc").read_bytes()[:900])
    with pytest.raises(InputError, match=r"holds no whole run \(.*broken\.nc: OSError\); write"):
        find([tmp_path])
    with pytest.raises(InputError, match=r"runs=.*broken\.nc: not readable \(OSError\); write it"):
        find([tmp_path / "broken.nc"])
    assert caplog.records == []  # one line says it all
    assert len(find([tmp_path, runs])) == len(find([runs]))
    assert [record.getMessage() for record in caplog.records] == [
        f"{tmp_path / 'broken.nc'}: passed over, not readable (OSError)"
    ]
    with pytest.raises(InputError, match="no such file or folder"):
        find([tmp_path / "absent"])


def test_difference_is_empty_for_a_run_and_itself_and_names_what_differs(runs):
    one, other = (runs / f"deep/{ratio}/piston.nc" for ratio in (0.5, 2.0))
    assert difference(one, one).empty
    found = difference(one, other).set_index("key")
    assert found.loc["piston.mass_ratio"].tolist() == [0.5, 2.0]
    assert found.loc["status"].tolist() == ["converged", "diverged"]
    keys = [key for key in found.index if not key.startswith("result.")]
    assert sorted(keys) == ["piston.mass_ratio", "status"]


def test_a_folder_stands_for_the_one_run_that_it_holds(runs):
    one, other = runs / "deep/0.5", runs / "deep/2.0/piston.nc"
    assert not difference(one, other).empty
    for pair in ((runs / "deep", one), (one, runs / "deep")):
        with pytest.raises(InputError, match=r"^runs=.*deep: holds 3 runs; give two files$"):
            difference(*pair)


def test_what_a_run_has_not_is_one_sign_in_the_difference(runs, tmp_path, capsys):
    files = str(runs / "deep/0.5/piston.nc"), str(runs / "roots.nc")
    write_difference(DifferenceCase(runs=files), tmp_path / "d.csv")
    printed = capsys.readouterr().out
    ends = {line.split()[0]: line.split()[-1] for line in printed.splitlines()}
    assert (ends["status"], ends["result.position_last"]) == ("-", "-")
    assert not {"nan", "None", "NaN"} & set(printed.split())


def test_the_difference_is_printed_in_short_and_never_as_equal(tmp_path, capsys):
    files = []
    for name, ratio in (("a", 2.25), ("b", 2.5), ("c", 2.25000001)):
        run = api.run("piston", "time.periods=0.1", f"piston.mass_ratio={ratio}")
        files.append(str(tmp_path / f"{name}.nc"))
        run.to_netcdf(files[-1], engine="h5netcdf")
    one, two, close = files
    for other, shown in ((two, ["2.25", "2.5"]), (close, ["2.25", "2.25000001"])):
        write_difference(DifferenceCase(runs=(one, other)), tmp_path / "d.csv")
        lines = capsys.readouterr().out.splitlines()
        assert ["piston.mass_ratio", *shown] in [line.split() for line in lines]
    write_difference(DifferenceCase(runs=(one, one)), tmp_path / "d.csv")
    assert capsys.readouterr().out == "no difference\n"


def test_the_command_prints_and_keeps_the_table(runs, squat, tmp_path):
    where = "where='piston' == kind and status == 'converged'"
    done = squat("task=catalogue", f"runs={runs}", where)
    assert done.returncode == 0, done.stderr
    assert "piston.mass_ratio" in done.stdout
    assert "2 runs" in done.stdout
    assert "piston.length" not in done.stdout
    kept = pd.read_parquet(tmp_path / "catalogue.parquet")
    assert sorted(kept["piston.mass_ratio"]) == [0.5, 0.9]
    assert "piston.length" in kept.columns


def test_parts_of_a_choice_are_printed_only_where_its_name_does_not_imply_them():
    rows = {
        "file": ["a", "b", "c"],
        "kind": ["transient"] * 3,
        "status": ["completed"] * 3,
        "coupling.name": ["printed", "printed", "newmark"],
        "coupling.integrator": ["centred", "centred", "newmark"],
        "coupling.criterion.tolerance": [1e-7, 1e-9, 1e-7],
        "current": [1.0, 2.0, 2.0],
    }
    shown = columns(pd.DataFrame(rows), ())
    assert list(shown) == [name for name in rows if name != "coupling.integrator"]


def test_a_terminal_gets_the_columns_that_fit_and_the_names_of_the_others(
    runs, tmp_path, capsys, monkeypatch
):
    case = CatalogueCase(runs=str(runs / "deep"), where="", sort=(), columns=())
    write_catalogue(case, tmp_path / "c.parquet")
    whole = capsys.readouterr().out.splitlines()
    monkeypatch.setattr("sys.stdout.isatty", lambda: True)
    width = len(whole[0]) - 1
    monkeypatch.setenv("COLUMNS", str(width))
    write_catalogue(case, tmp_path / "c.parquet")
    head, *rest = capsys.readouterr().out.splitlines()
    last = whole[0].split()[-1]
    assert head.split() == whole[0].split()[:-1]
    assert f"not shown: {last}" in rest
    assert max(map(len, rest[: len(RATIOS)])) <= width


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
        ("scheme", None, "scheme: one value a run; give over=KEY"),
        ("result.step", None, "result.step: no run has that; .* as result.*result.steps"),
    ],
)
def test_what_cannot_be_compared_is_told_apart_from_what_is_not_there(runs, variable, over, said):
    table = select(find([runs]), "kind == 'piston'")
    with pytest.raises(InputError, match=said):
        draw(table, variable, over)


def test_units_stay_whole_at_the_end_of_long_labels(runs):
    table = select(find([runs]), "kind == 'piston'")
    long = "velocity of the piston along its long axis, positive up"
    assert _axis(long, "m s-1").splitlines()[-1].endswith("[m s-1]")
    figure = draw(table, "position", None)
    (axes,) = figure.axes
    axes.set_ylabel(_axis(long + ", seen by one who stands still on the bank", "kg m-1 s-2"))
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
        "result.position_last [m]",
        "result.predicted_contraction [-]",
        "result.iterations_mean [-]",
        "result.steps",
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
    assert labels == ["result.added_mass_heave [kg m-1]", "result.added_mass_pitch [kg m]"]


def test_a_run_of_one_point_is_seen(tmp_path):
    keys = "mesh=coarse", "accuracy.near=0.4", "time.periods=0.05", "current=1"
    for name in ("printed", "printed_standard"):
        run = api.run("transient", *keys, f"coupling={name}")
        run.to_netcdf(tmp_path / f"{name}.nc", engine="h5netcdf")
    (axes,) = draw(find([tmp_path]), "heave", None).axes
    looks = {line.get_label(): (len(line.get_xdata()), line.get_marker()) for line in axes.lines}
    assert looks["coupling = printed_standard: diverged"] == (1, "o")
    assert looks["coupling = printed: completed"][1] == "None"


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


def test_a_key_that_some_runs_lack_is_named_only_where_nothing_else_tells():
    table = pd.DataFrame(
        {"modes": ['["heave"]', '["heave"]', None], "hull.draft": [8.0, 9.0, 10.0], "kind": "x"}
    )
    assert telling(table) == ["hull.draft"]
    assert telling(table.assign(**{"hull.draft": [8.0, 9.0, 9.0]})) == ["hull.draft", "modes"]


def test_runs_without_the_variable_are_skipped_and_counted(runs, tmp_path, caplog):
    out = tmp_path / "compare.png"
    write_compare(CompareCase(runs=str(runs), where="", variable=None, over=None), out)
    assert out.exists()
    (axes,) = draw(find([runs]), "position", None).axes
    assert len(axes.lines) == len(RATIOS)
    draw(find([runs]), "result.position_last", "piston.mass_ratio")
    assert [record.getMessage() for record in caplog.records] == [
        "1 of 4 runs skipped: without position",
        "1 of 4 runs skipped: without position",
        "1 of 4 runs skipped: without result.position_last and piston.mass_ratio",
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
    labels = {line.get_label() for line in axes.lines}
    assert labels == {f"coupling = {name}" for name in table["coupling.name"]}
    (axes,) = draw(table.drop(columns="coupling.name").iloc[:2], "position", None).axes
    assert [line.get_label() for line in axes.lines] == ["hull = lewis", "hull = rectangle"]


def test_the_command_writes_both_pictures(runs, squat, tmp_path):
    done = squat("task=compare", f"runs={runs / 'deep'}")
    assert done.returncode == 0, done.stderr
    assert (tmp_path / "compare.png").read_bytes().startswith(b"\x89PNG")
    assert "<svg" in (tmp_path / "compare.svg").read_text()


@pytest.mark.parametrize("runs", ["", ("deep", "")])
def test_an_empty_name_is_no_folder(runs):
    with pytest.raises(InputError, match="runs: a name is empty; give folders or files"):
        places(runs)
