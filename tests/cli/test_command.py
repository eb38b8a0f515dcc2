"""The real command: exit codes, one line of error, multiruns, help."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

from squat.catalogue import find
from squat.records import read


@pytest.mark.parametrize(
    ("arguments", "line"),
    [
        ([], "squat: task: missing; give task=NAME, one of added_mass,"),
        (["task=foo"], "squat: task=foo: unknown; give one of added_mass,"),
        (["task=piston", "pistn.x=2"], "squat: pistn.x=2: unknown key;"),
        (
            ["task=limits", "hull=lewis", "hull.area_coeficient=0.8"],
            "squat: hull.area_coeficient=0.8: unknown key; did you mean 'hull.area_coefficient'? "
            "squat task=NAME --cfg job lists the keys",
        ),
        (
            ["-m", "task=piston", "pistn.mass_ratio=1,2", "time.periods=1,2"],
            "squat: pistn.mass_ratio=1: unknown key; did you mean 'piston.mass_ratio'? squat",
        ),
        (
            ["-m", "task=mesh", "hull=lewis,v", "hull.segments=24"],
            "squat: hull.segments=24: a key of hull=lewis, not of hull=v; put it into a file of",
        ),
        (["task=piston", "+pistn.x=2"], "squat: pistn={'x': 2}: unknown key;"),
        (["task=piston", "piston.mass_ratio=0"], "squat: piston.mass_ratio=0: must be greater"),
        (["task=piston", "out=["], "squat: out=[: cannot be read; give KEY=VALUE, its brackets"),
        (
            ["task=piston", "out=a=b.nc"],
            "squat: out=a=b.nc: cannot be read; give KEY=VALUE, VALUE in quotes within those of "
            """the shell: 'out="a=b.nc"'""",
        ),
        (
            ["task=piston", f"out={200 * 'a'}=b"],
            f"squat: out={200 * 'a'}=b: cannot be read; give KEY=VALUE, VALUE in quotes within "
            "those of the shell\n",
        ),
        (["task=piston", "out=a.csv"], "squat: out=a.csv: must end in .nc;"),
        (["task=piston", "piston=null"], "squat: Config group override must be"),
        (["task=piston", "accelerator=foo"], "squat: accelerator=foo: unknown; give one of"),
        (["task=piston", "piston.length=${no}"], "squat: Interpolation key 'no' not found"),
        (["task=equilibria", "hull.draft=25"], "squat: hull.draft=25: must be less than"),
        (["task=table", "name=table2", "data=no.nc"], "squat: no.nc: no such file;"),
        (["task=table", "data=no.nc"], "squat: name: missing; give name=VALUE"),
        (["--nonsense"], "squat: unrecognized arguments: --nonsense;"),
    ],
)
def test_bad_input_is_one_line_and_exit_code_2(squat, tmp_path, arguments, line):
    done = squat(*arguments)
    assert done.returncode == 2
    assert done.stdout == ""
    assert done.stderr.startswith(line)
    assert done.stderr.count("\n") == 1
    assert list(tmp_path.iterdir()) == []


def test_unwritable_output_is_one_line(squat, tmp_path):
    (tmp_path / "file").touch()
    done = squat("task=piston", "out=file/run.nc")
    assert done.returncode == 2
    assert done.stderr.startswith("squat: file/run.nc: cannot be written")
    assert done.stderr.count("\n") == 1


@pytest.mark.parametrize("folder", ["file", "file/deeper"])
def test_a_sweep_that_cannot_write_is_one_line_that_names_its_folder(squat, tmp_path, folder):
    (tmp_path / "file").touch()
    done = squat("-m", "task=piston", "piston.mass_ratio=1,2", f"hydra.sweep.dir={folder}")
    assert done.returncode == 2
    assert done.stderr.startswith(f"squat: hydra.sweep.dir={folder}: cannot be written (")
    assert done.stderr.count("\n") == 1
    assert [path.name for path in tmp_path.iterdir()] == ["file"]


def test_divergence_is_a_result(squat, tmp_path):
    done = squat("task=piston", "piston.mass_ratio=2", "scheme=standard", "out=deep/run.nc")
    assert done.returncode == 0, done.stderr
    assert read(tmp_path / "deep" / "run.nc").attrs["status"] == "diverged"


def test_multirun_names_failed_jobs_and_keeps_the_others(squat, tmp_path):
    done = squat("-m", "task=piston", "piston.mass_ratio=-1,0.5,2", "time.periods=0.1")
    assert done.returncode == 2
    assert "piston.mass_ratio=-1: must be greater than 0" in done.stderr
    assert "Traceback" not in done.stderr
    found = sorted(path.parent.name for path in tmp_path.glob("multirun/piston/*/piston.nc"))
    assert found == [f"piston.mass_ratio-{ratio}__time.periods-0.1" for ratio in ("0.5", "2")]
    again = squat("-m", "task=piston", "piston.mass_ratio=0.5,2", "time.periods=0.1")
    assert again.returncode == 0, again.stderr
    assert list(find([tmp_path])["piston.mass_ratio"]) == [0.5, 2]


def test_a_complete_job_is_skipped_and_a_broken_one_done_again_unless_redo_asks(squat, tmp_path):
    command = "-m", "task=piston", "piston.mass_ratio=0.5,2", "hydra.launcher.n_jobs=1"
    whole, broken = (
        tmp_path / f"multirun/piston/piston.mass_ratio-{r}/piston.nc" for r in (2, 0.5)
    )
    assert squat(*command).returncode == 0
    before = whole.read_bytes()
    left = whole.with_name("piston.nc.parts")  # by a kill between the file and their removal
    left.mkdir()
    (left / "000000000.npz").touch()
    broken.write_bytes(before[:-100])
    again = squat(*command).stderr
    assert again.count("complete, skipped") == 1
    assert "jobs: 2 of 2, 1 skipped (1 converged)" in again
    assert whole.read_bytes() == before
    assert not left.exists()
    assert read(broken).attrs["status"] == "converged"
    assert "skipped" not in squat(*command, "redo=true").stderr


def test_a_multirun_refuses_unknown_choices_and_several_tasks_before_it_starts(squat, tmp_path):
    done = squat("-m", "task=piston", "accelerator=none,nonsense")
    assert done.returncode == 2
    assert done.stderr.startswith("squat: accelerator=nonsense: unknown; give one of")
    done = squat("-m", "task=piston,equilibria")
    assert "a multirun has one task" in done.stderr
    assert list(tmp_path.iterdir()) == []


def test_help_config_and_completion_work(squat):
    shown = squat("--help")
    assert shown.returncode == 0
    assert "squat task=NAME [key=value ...]" in shown.stdout
    config = squat("task=piston", "--cfg", "job")
    assert "mass_ratio: 1.0" in config.stdout
    completion = squat("-sc", "install=bash")
    assert "hydra_bash_completion" in completion.stdout
    assert squat("--version").stdout.startswith("squat ")


@pytest.mark.parametrize("arguments", [["--help"], ["--version"], ["task=catalogue", "runs=."]])
def test_a_pipe_that_is_closed_ends_the_command_without_a_word(squat, tmp_path, arguments):
    assert squat("task=piston", "time.periods=0.1").returncode == 0
    read_end, write_end = os.pipe()
    os.close(read_end)
    command = [str(Path(sys.executable).parent / "squat"), *arguments]
    with os.fdopen(write_end, "w") as closed:
        done = subprocess.run(
            command, cwd=tmp_path, stdout=closed, stderr=subprocess.PIPE, text=True, check=False
        )
    assert (done.returncode, done.stderr) == (141, "")
    assert (tmp_path / "catalogue.parquet").is_file() == ("task=catalogue" in arguments)


def test_two_level_names_and_equals_signs_in_files_work_when_quoted(squat, tmp_path):
    done = squat("task=piston", "time.periods=0.1", 'out="a=b,c~.nc"')
    assert done.returncode == 0, done.stderr
    assert (tmp_path / "a=b,c~.nc").is_file()


def test_added_mass_of_section_3_6_is_one_command_of_less_than_ten_seconds(squat, tmp_path):
    geometry = "hull.length=40 hull.draft=10 channel.depth=20 channel.upstream=40"
    ends = "channel.downstream=60 free_surface=zero_pressure out=m.nc"
    done = squat("task=added_mass", *geometry.split(), *ends.split(), timeout=30)
    assert done.returncode == 0
    data = read(tmp_path / "m.nc")
    assert data.attrs["wall_time"] < 10
    assert list(data["mode"].values) == ["surge", "heave", "pitch"]
