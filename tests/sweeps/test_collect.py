"""A multirun joined into one: every number where its parameters say, nothing lost unsaid."""

import json
import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import numpy as np
import psutil
import pytest

from squat.catalogue.difference import difference
from squat.cli.tasks import collect
from squat.config import compose, validate
from squat.config.units import unit
from squat.errors import InputError
from squat.piston import run
from squat.records import build, read, read_group, save
from squat.records.schema import Kind, Variable
from squat.stability.limits import run as limits
from squat.stability.run import run as equilibria
from squat.sweeps import FAILED, CollectCase, write_plan
from squat.sweeps.folders import job_folder, was_cut
from squat.sweeps.stack import stack


@pytest.fixture
def job(tmp_path):
    """Write the dataset of one job as a multirun does."""

    def write(name, *overrides, task="piston", make=run, chosen=None):
        valid = validate(compose(task, *overrides))
        dataset = make(valid.case)
        path = tmp_path / name / f"{task}.nc"
        path.parent.mkdir(parents=True, exist_ok=True)
        save(dataset, path, valid.config, 0.0, choices=chosen)
        return dataset

    return write


@pytest.fixture
def joined(tmp_path):
    def make(where=""):
        return collect(CollectCase(runs=str(tmp_path), where=where))

    return make


SHORT = "time.periods=0.1"


def test_every_value_stands_where_its_parameters_say(job, joined):
    made = {
        (ratio, scheme): job(
            f"{ratio}{scheme}", SHORT, f"piston.mass_ratio={ratio}", f"scheme={scheme}"
        )
        for ratio in (2, 0.5, 0.7)
        for scheme in ("standard", "corrected")
    }
    sweep = joined()
    assert list(sweep["mass_ratio"].values) == [0.5, 0.7, 2]
    assert json.loads(sweep.attrs["axes"]) == {
        "mass_ratio": "piston.mass_ratio",
        "scheme": "scheme",
    }
    for (ratio, scheme), one in made.items():
        cell = sweep.sel(mass_ratio=ratio, scheme=scheme)
        assert cell["job_status"] == one.attrs["status"]
        for name, variable in one.variables.items():
            found = cell[name].values
            inside = tuple(slice(n) for n in variable.shape)
            assert np.array_equal(found[inside], variable.values, equal_nan=True), name
            outside = np.ones(found.shape, bool)
            outside[inside] = False
            assert np.isnan(found[outside]).all(), name
    assert json.loads(sweep.attrs["missing"]) == []
    assert sweep["position"].attrs["units"] == "m"
    assert sweep["position"].attrs["long_name"].endswith("; NaN: no such job, or a shorter one")
    assert sweep["mass_ratio"].attrs["units"] == "1"


def test_swept_parameters_carry_the_units_of_their_keys(job, joined):
    for draft in (9, 10):
        job(f"{draft}", f"hull.draft={draft}", task="equilibria", make=equilibria)
    assert joined()["draft"].attrs == {"units": "m", "long_name": "swept: hull.draft"}
    assert unit("transient", "current") == "m/s"
    assert unit("trim", "start.pitch") == "rad"
    assert unit("transient", "coupling.criterion.tolerance") is None
    assert unit("nothing", "current") is None
    assert unit("piston", "piston.mass_ratio") == unit("piston", "piston.added_mass_ratio") == "1"


def test_what_was_given_is_the_axis_also_where_another_key_follows_it(job, joined, tmp_path):
    """A file tells lengths that follow from drafts; before the draft in its configuration."""
    plan = {}
    for draft, length in ((5.0, 40.0), (9.0, 41.0)):
        plan[f"d{draft:g}"] = ["task=equilibria", f"hull.draft={draft}"]
        keys = f"hull.draft={draft}", f"hull.length={length}"
        job(f"d{draft:g}", *keys, task="equilibria", make=equilibria)
    assert json.loads(joined().attrs["axes"]) == {"length": "hull.length"}
    write_plan(tmp_path, "equilibria", plan)
    assert json.loads(joined().attrs["axes"]) == {"draft": "hull.draft"}


def test_a_swept_value_that_the_kind_holds_is_its_own_dimension(job, joined):
    for current in (1.0, 2.0):
        keys = "accuracy=study", "accuracy.near=0.64", f"current={current}"
        job(f"{current}", *keys, task="limits", make=limits)
    sweep = joined()
    assert list(sweep["current"].values) == [1.0, 2.0]
    assert sweep["limit_speed"].dims[0] == "current"
    assert "current" not in json.loads(sweep.attrs["joined"])["variables"]


def test_sweeps_differ_by_what_was_joined_what_was_swept_and_what_is_common(job, tmp_path):
    files = []
    for name, ratios, length in (("a", (1, 2), 1), ("b", (1, 3), 2)):
        for ratio in ratios:
            keys = SHORT, f"piston.mass_ratio={ratio}", f"piston.length={length}"
            job(f"{name}/{ratio}", *keys)
        config = compose("collect", f"runs={tmp_path / name}")
        sweep = collect(CollectCase(runs=str(tmp_path / name), where=""))
        save(sweep, tmp_path / f"{name}.nc", config, 0.0)
        files.append(tmp_path / f"{name}.nc")
    found = difference(*files).set_index("key")
    assert list(found.loc["piston.mass_ratio"]) == ["[1.0, 2.0]", "[1.0, 3.0]"]
    assert list(found.loc["piston.length"]) == [1, 2]
    assert len(found) == 2
    assert difference(files[0], files[0]).empty
    single = tmp_path / "a/1/piston.nc"
    assert difference(files[0], single).set_index("key").loc["joined", str(files[0])] == "piston"


def test_a_coordinate_stays_one_dimensional_only_where_all_jobs_agree(job, joined):
    job("a", SHORT)
    job("b", "time.periods=0.2")
    assert joined()["time"].dims == ("time",)
    assert joined().sizes["time"] == 15
    job("c", SHORT, "piston.length=2")
    sweep = joined()
    assert sweep["time"].dims == ("length", "periods", "time_index")
    assert float(sweep["time"].sel(length=2, periods=0.1)[1]) == pytest.approx(
        float(sweep["time_step"].sel(length=2, periods=0.1))
    )


def test_a_choice_is_one_parameter_with_its_name_as_label(job, joined):
    job("a", SHORT)
    job("b", SHORT, "accelerator=aitken")
    job("c", SHORT, "accelerator=relaxation", "accelerator.factor=0.4")
    sweep = joined()
    assert json.loads(sweep.attrs["axes"]) == {"accelerator": "accelerator"}
    assert set(sweep["accelerator"].values) == {"none", "aitken", "relaxation"}
    job("d", SHORT, "accelerator=relaxation", "accelerator.factor=0.5")
    assert set(joined().sizes) >= {"accelerator", "factor"}
    assert joined()["job_name"].sel(accelerator="relaxation", factor="0.5") == "d"


def test_a_choice_without_a_name_is_labelled_by_the_plan(job, joined, tmp_path):
    plan = {name: ["task=equilibria", f"channel={name}"] for name in ("paper", "fig7")}
    for name in plan:
        job(name, f"channel={name}", task="equilibria", make=equilibria)
    write_plan(tmp_path, "equilibria", plan)
    sweep = joined()
    assert json.loads(sweep.attrs["axes"]) == {"channel": "channel"}
    assert list(sweep["channel"].values) == ["paper", "fig7"]


def test_without_a_plan_it_is_labelled_by_what_the_files_say_of_their_choices(job, joined):
    for name in ("paper", "fig7"):
        chosen = {"channel": name, "hull": "section36"}
        job(name, f"channel={name}", task="equilibria", make=equilibria, chosen=chosen)
    sweep = joined()
    assert json.loads(sweep.attrs["axes"]) == {"channel": "channel"}
    assert set(sweep["channel"].values) == {"paper", "fig7"}


def test_failed_and_missing_jobs_are_named_and_have_their_place(job, joined, tmp_path, caplog):
    plan = {
        f"r{ratio}s{n}": ["task=piston", SHORT, f"piston.mass_ratio={ratio}", f"scheme={scheme}"]
        for ratio in ("-1", "0.5", "2")
        for n, scheme in enumerate(("standard", "corrected"))
    }
    write_plan(tmp_path, "piston", plan)
    for name in ("r0.5s0", "r0.5s1"):
        job(name, *plan[name][1:])
    for name in ("r-1s0", "r-1s1"):
        (tmp_path / name).mkdir()
        (tmp_path / name / FAILED).write_text("piston.mass_ratio=-1: must be greater than 0\n")
    (tmp_path / "r2s0").mkdir()
    (tmp_path / "r2s0" / "piston.nc").write_text("cut short")
    sweep = joined()
    status = sweep["job_status"]
    assert sweep.sizes["mass_ratio"] == 3
    assert (status.sel(mass_ratio=-1) == "failed").all()
    assert status.sel(mass_ratio=2, scheme="corrected") == "missing"
    assert np.isnan(sweep["position"].sel(mass_ratio=-1)).all()
    assert not np.isnan(sweep["position"].sel(mass_ratio=0.5)).all()
    failed = json.loads(sweep.attrs["failed"])
    assert failed["r-1s0"] == "piston.mass_ratio=-1: must be greater than 0"
    assert "not a readable NetCDF-4 file" in failed["r2s0"]
    assert status.sel(mass_ratio=2, scheme="standard") == "failed"
    assert json.loads(sweep.attrs["missing"]) == ["r2s1"]
    assert "r2s1: missing" in caplog.text
    assert "r-1s0: failed: piston.mass_ratio=-1" in caplog.text


def test_jobs_of_sweeps_in_folders_within_have_their_place_too(job, joined, tmp_path):
    for sweep, ratios in (("a", (-1, 1)), ("b", (-3, 2))):
        plan = {
            f"r{ratio}": ["task=piston", SHORT, f"piston.mass_ratio={ratio}"] for ratio in ratios
        }
        (tmp_path / sweep).mkdir()
        write_plan(tmp_path / sweep, "piston", plan)
        job(f"{sweep}/r{ratios[1]}", *plan[f"r{ratios[1]}"][1:])
    (tmp_path / "other").mkdir()
    write_plan(tmp_path / "other", "equilibria", {"none": ["task=equilibria"]})
    sweep = joined()
    status = dict(zip(sweep["mass_ratio"].values, sweep["job_status"].values, strict=True))
    assert status == {-3: "failed", -1: "failed", 1: "converged", 2: "converged"}
    assert json.loads(sweep.attrs["missing"]) == []


def test_a_refused_value_has_its_place_beside_numbers_that_follow_from_others(
    job, joined, tmp_path
):
    plan = {
        depth: ["task=equilibria", "hull=polygon", f"channel.depth={depth}"]
        for depth in ("16", "20", "-1")
    }
    write_plan(tmp_path, "equilibria", plan)
    job("16", *plan["16"][1:], task="equilibria", make=equilibria)
    assert compose("equilibria", "hull=polygon")["hull"]["draft"] is None  # of a whole job 10 m
    sweep = joined()
    assert json.loads(sweep.attrs["axes"]) == {"depth": "channel.depth"}
    status = dict(zip(sweep["depth"].values, sweep["job_status"].values, strict=True))
    assert status == {-1: "failed", 16: "completed", 20: "missing"}
    assert "channel.depth=-1: must be greater than 0" in str(sweep["job_failure"].sel(depth=-1))


def test_of_a_folder_that_holds_several_sweeps_a_condition_joins_one(job, joined, tmp_path):
    for scheme in ("standard", "corrected"):
        job(f"a-{scheme}", SHORT, f"scheme={scheme}")
        job(f"b-{scheme}", SHORT, f"scheme={scheme}", "piston.length=2", "accelerator=aitken")
    write_plan(tmp_path, "piston", {"c": ["task=piston", "scheme=consistent", SHORT]})
    sweep = joined("piston.length == 2")
    assert json.loads(sweep.attrs["axes"]) == {"scheme": "scheme"}
    assert set(sweep["job_name"].values) == {"b-standard", "b-corrected"}
    assert json.loads(sweep.attrs["missing"]) == []
    with pytest.raises(InputError, match="length == 3: no run in"):
        joined("piston.length == 3")


def test_cells_that_nobody_planned_are_named_by_their_parameters(job, joined):
    job("a", SHORT, "scheme=standard")
    job("b", SHORT, "scheme=corrected")
    job("c", SHORT, "scheme=corrected", "piston.length=2")
    assert json.loads(joined().attrs["missing"]) == ["piston.length=2 scheme=standard"]


def test_what_cannot_be_joined_is_one_line(job, joined, tmp_path):
    with pytest.raises(InputError, match="holds no dataset; give the folder"):
        joined()
    (tmp_path / "lost").mkdir()
    (tmp_path / "lost" / FAILED).write_text("current=-1: must be positive\ntrace\n")
    with pytest.raises(InputError, match=r"all jobs failed .*: current=-1: must be positive\)"):
        joined()
    (tmp_path / "lost" / FAILED).unlink()
    job("a", SHORT)
    job("b", SHORT)
    with pytest.raises(InputError, match="a and b have the same parameters"):
        joined()
    job("b", task="equilibria", make=equilibria)
    (tmp_path / "b" / "piston.nc").unlink()
    with pytest.raises(InputError, match="holds equilibria and piston"):
        joined()
    with pytest.raises(InputError, match="no such folder"):
        collect(CollectCase(runs="nowhere", where=""))


def test_a_sweep_is_read_back_and_an_altered_one_refused(job, joined, tmp_path):
    job("a", SHORT, "scheme=standard")
    job("b", SHORT, "scheme=corrected")
    sweep, path = joined(), tmp_path / "sweep.nc"
    save(sweep, path, {"task": "collect"}, 0.0)
    back = read(path)
    assert sorted(back.variables) == sorted(sweep.variables)
    assert back["position"].attrs["units"] == "m"
    assert joined().equals(sweep)  # a sweep among the runs is not one of them
    with pytest.raises(InputError, match="no group 'fields'; a sweep's jobs keep theirs"):
        read_group(path, "fields")
    save(sweep.drop_vars("velocity"), path, {}, 0.0)
    with pytest.raises(InputError, match="'velocity' is not what was joined"):
        read(path)


def test_a_killed_sweep_goes_on_with_the_same_command_and_is_joined(squat, tmp_path):
    command = ["-m", "task=piston", "piston.mass_ratio=0.2,0.3,0.4", "time.periods=200"]
    victim = subprocess.Popen(
        [str(Path(sys.executable).parent / "squat"), *command, "hydra.launcher.n_jobs=2"],
        cwd=tmp_path, stderr=subprocess.DEVNULL, env={**os.environ, "OMP_NUM_THREADS": "1"},
    )  # fmt: skip
    runs = tmp_path / "multirun" / "piston"
    while not (first := list(runs.glob("*/piston.nc"))):
        time.sleep(0.01)
        assert victim.poll() is None
    victim.send_signal(signal.SIGKILL)
    victim.wait()
    stamps = {path: path.stat().st_mtime_ns for path in first}
    cut = squat("task=collect", f"runs={runs}", "out=cut.nc")
    assert cut.returncode == 0, cut.stderr
    done = squat(*command, "hydra.launcher.n_jobs=2")
    assert done.returncode == 0, done.stderr
    assert done.stderr.count("complete, skipped") >= len(first)
    assert "jobs: 3 of 3" in done.stderr
    assert {path: path.stat().st_mtime_ns for path in first} == stamps
    whole = collect(CollectCase(runs=str(runs), where=""))
    assert (whole["job_status"] == "converged").all()
    assert list(whole["mass_ratio"].values) == [0.2, 0.3, 0.4]
    assert list(read(tmp_path / "cut.nc")["mass_ratio"].values) == [0.2, 0.3, 0.4]


def test_a_job_whose_name_no_file_system_takes_has_a_shorter_one(squat, tmp_path):
    points = [[0, 0], *([x, -4 - x * (30 - x) / 100] for x in range(31)), [30, 0]]
    hull = "hull=polygon", f"hull.points={points}".replace(" ", "")
    command = ["-m", "task=equilibria", *hull, "accuracy=coarse", "channel.depth=20,25"]
    done = squat(*command, "hydra.launcher.n_jobs=1")
    assert done.returncode == 0, done.stderr
    names = [path.parent.name for path in tmp_path.rglob("equilibria.nc")]
    assert len(names) == 2
    assert all(len(name.encode()) <= 200 for name in names)
    again = squat(*command, "hydra.launcher.n_jobs=1")
    assert again.stderr.count("complete, skipped") == 2
    joined = squat("task=collect", "runs=multirun/equilibria", "out=sweep.nc")
    assert joined.returncode == 0, joined.stderr
    assert list(read(tmp_path / "sweep.nc")["depth"].values) == [20.0, 25.0]


def test_short_names_stay_and_cut_ones_differ():
    assert job_folder("current-1__hull-rectangle") == "current-1__hull-rectangle"
    names = {job_folder("\N{GREEK SMALL LETTER OMEGA}" * 300 + end) for end in "ab"}
    assert len(names) == 2
    assert max(len(name.encode()) for name in names) <= 200
    assert job_folder("a/" + "b" * 300).startswith("a/b")
    assert all(map(was_cut, names))
    assert not was_cut("current-1__hull-rectangle")


def is_worker(process):
    try:
        return "popen_loky_posix" in " ".join(process.cmdline())
    except psutil.Error:  # it has ended meanwhile
        return False


def test_workers_end_with_a_killed_sweep_even_while_they_still_load(tmp_path):
    victim = subprocess.Popen(
        [str(Path(sys.executable).parent / "squat"), "-m", "task=piston", "time.periods=1000",
         "piston.mass_ratio=0.2,0.3,0.4", "hydra.launcher.n_jobs=2"],
        cwd=tmp_path, stderr=subprocess.DEVNULL, env={**os.environ, "OMP_NUM_THREADS": "1"},
    )  # fmt: skip
    sweep = psutil.Process(victim.pid)
    while not any(map(is_worker, sweep.children())):
        time.sleep(0.01)
        assert victim.poll() is None
    children = sweep.children(recursive=True)
    victim.send_signal(signal.SIGKILL)
    victim.wait()
    _, alive = psutil.wait_procs(children, timeout=60)
    assert alive == []
    assert not list(tmp_path.rglob("*.nc"))


def test_what_the_first_job_lacks_is_stacked_with_its_own_dimensions():
    """As curves over heave, which ships of several modes do not have."""
    curve = Variable(("point",), "m", "a curve", required=False)
    kind = Kind("probe", 1, "probe", {"end": Variable((), "m", "end"), "curve": curve})
    without, held = build(kind, {"end": 1.0}), build(kind, {"end": 2.0, "curve": [3.0, 4.0]})
    variables, data = stack(kind, {(0,): without, (1,): held}, ("job",), (2,))
    assert variables["curve"].dims == ("job", "point")
    assert np.array_equal(data["curve"], [[np.nan] * 2, [3, 4]], equal_nan=True)
