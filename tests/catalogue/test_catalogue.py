"""Runs are found wherever they lie, told apart by what differs, filtered, sorted, compared."""

import json
import shutil

import numpy as np
import pandas as pd
import pytest
import xarray as xr

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
from squat.errors import InputError
from tests.catalogue.runs import RATIOS


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
        assert lines[:2] == [f"A: {one}", f"B: {other}"]
        assert lines[2].split() == ["key", "A", "B"]
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


def test_a_sweep_that_failed_as_a_whole_is_said_to_have(tmp_path):
    with pytest.raises(InputError, match="holds no run; give"):
        find([tmp_path])
    (tmp_path / "bad").mkdir()
    (tmp_path / "bad" / "failed.txt").write_text("refused\n")
    with pytest.raises(InputError, match=r"holds no run, 1 jobs failed \(failed.txt"):
        find([tmp_path])


@pytest.mark.parametrize(
    ("where", "said"), [("", ""), ("kind == 'piston'", ", whatever where= asks")]
)
def test_jobs_that_failed_are_counted(runs, tmp_path, capsys, where, said):
    shutil.copytree(runs, tmp_path / "runs")
    (tmp_path / "runs" / "bad").mkdir()
    (tmp_path / "runs" / "bad" / "failed.txt").write_text("refused\n")
    case = CatalogueCase(runs=str(tmp_path / "runs"), where=where, sort=(), columns=())
    write_catalogue(case, tmp_path / "all.parquet")
    assert f" runs; 1 job failed (failed.txt in their folders{said}); " in capsys.readouterr().out


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


@pytest.mark.parametrize("runs", ["", ("deep", "")])
def test_an_empty_name_is_no_folder(runs):
    with pytest.raises(InputError, match="runs: a name is empty; give folders or files"):
        places(runs)
