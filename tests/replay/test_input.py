"""Files that cannot be replayed, and how several are named."""

import re
import time

import numpy as np
import pytest

from squat import records
from squat.cli.arguments import readable
from squat.errors import InputError
from squat.records.transient_kinds import TRANSIENT
from squat.replay.case import ReplayCase
from squat.replay.runs import load
from squat.replay.write import write_replay


def refused(tmp_path, *files):
    out = tmp_path / "out.rrd"
    with pytest.raises(InputError) as caught:
        write_replay(ReplayCase(run=tuple(map(str, files))), out)
    assert not out.exists()
    message = str(caught.value)
    assert "\n" not in message
    return message


def test_broken_and_foreign_files_are_named(tmp_path, ship, tube):
    (tmp_path / "cut.nc").write_bytes(ship.read_bytes()[:3000])
    (tmp_path / "text.nc").write_text("no NetCDF")
    assert "cut.nc: not a readable" in refused(tmp_path, tmp_path / "cut.nc")
    assert "text.nc: not a readable" in refused(tmp_path, tmp_path / "text.nc")
    assert "none.nc: no such file" in refused(tmp_path, tmp_path / "none.nc")
    assert re.search(
        r"tube.nc: holds 'piston', .*ship.nc 'transient'", refused(tmp_path, ship, tube)
    )


def test_a_folder_that_holds_one_run_stands_for_it(tmp_path, ship, tube, record, entities):
    for name, path in (("first", ship), ("other", tube)):
        (tmp_path / name / "deep").mkdir(parents=True)
        (tmp_path / name / "deep" / "run.nc").write_bytes(path.read_bytes())
    (run,) = load((str(tmp_path / "first"),))
    assert run.path == tmp_path / "first" / "deep" / "run.nc"
    assert "plots/heave/heave" in entities(record(tmp_path / "first"))
    assert re.search("holds 'piston'", refused(tmp_path, tmp_path / "first", tmp_path / "other"))


def test_a_folder_of_several_runs_or_of_none_is_named(tmp_path, ship, tube):
    for name, path in (("a.nc", ship), ("b.nc", tube)):
        (tmp_path / name).write_bytes(path.read_bytes())
    assert refused(tmp_path, tmp_path) == (
        f"run={tmp_path}: is a folder of 2 runs; give some of its .nc files, as run=A.nc,B.nc"
    )
    (tmp_path / "none").mkdir()
    assert "none: is a folder without a run" in refused(tmp_path, tmp_path / "none")


def test_snapshots_that_lack_a_variable_are_named(tmp_path, ship):
    path = tmp_path / "lame.nc"
    run, snapshots = records.read(ship, TRANSIENT), records.read_group(ship, "fields")
    lame = {"fields": snapshots.drop_vars("velocity_x")}
    records.save(run, path, records.config_of(run), time.perf_counter(), lame)
    assert "lame.nc: snapshots lack 'velocity_x'" in refused(tmp_path, path)


def test_a_failed_recording_leaves_the_older_one(tmp_path, ship, monkeypatch):
    out = tmp_path / "out.rrd"
    out.write_bytes(b"older")
    monkeypatch.setattr("squat.replay.write.draw_all", lambda *_: np.zeros(1)[2])
    with pytest.raises(IndexError):
        write_replay(ReplayCase(run=str(ship)), out)
    assert out.read_bytes() == b"older"
    assert list(tmp_path.iterdir()) == [out]


@pytest.mark.parametrize(
    ("typed", "read"),
    [
        (["task=replay", "run=A.nc,B.nc"], 'run=["A.nc","B.nc"]'),
        (["run=a=1.nc,b 2.nc", "task=replay"], 'run=["a=1.nc","b 2.nc"]'),
        (["task=replay", "run=[A.nc,B.nc]"], "run=[A.nc,B.nc]"),
        (["task=replay", "run=A.nc"], "run=A.nc"),
        (["task=replay", "run='A,B.nc'"], "run='A,B.nc'"),
        (["task=replay", "-m", "run=A.nc,B.nc"], "run=A.nc,B.nc"),
        (["task=piston", "run=A.nc,B.nc"], "run=A.nc,B.nc"),
    ],
)
def test_commas_make_a_list_where_hydra_would_refuse_them(typed, read):
    assert read in readable(typed)


def test_the_command_compares_by_commas(squat, tmp_path, ship, bare):
    done = squat("task=replay", f"run={ship},{bare}", "out=both.rrd")
    assert done.returncode == 0, done.stderr
    assert (tmp_path / "both.rrd").stat().st_size > 0
    assert "Warning" not in done.stderr


def test_a_bad_run_is_one_line(squat, tmp_path):
    done = squat("task=replay", "run=no.nc")
    assert done.returncode == 2
    assert done.stderr.startswith("squat: no.nc: no such file;")
    assert done.stderr.count("\n") == 1
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize(
    ("run", "line"),
    [
        ("run=a.nc,", "run=a.nc,: an empty name;"),
        ("run=a.nc,a.nc", "run=a.nc,a.nc: a.nc twice;"),
    ],
)
def test_impossible_lists_are_named(case, run, line):
    with pytest.raises(InputError, match=re.escape(line)):
        case("replay", *readable(["task=replay", run])[1:])
