"""Full disks, read-only folders, two runs at once, clocks moved back."""

import contextlib
import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

from squat.cli.tasks import compute
from squat.config import compose, validate
from squat.records import claim, read_whole
from squat.records.provenance import digest

SQUAT = Path(sys.executable).parent / "squat"
QUICK = "task=piston", "time.periods=0.3"
REFUSED = "squat: run.nc: another run is writing it; wait for it, or give another out=\n"


@pytest.fixture(scope="module")
def expected():
    return digest(compute(validate(compose("piston", "time.periods=0.3"))))


@pytest.fixture
def start(forks):
    """Start the command; its stderr goes into a pipe that `end` reads."""

    def started(folder, *words, program=forks.program):
        return subprocess.Popen(
            [str(program), *words], cwd=folder, stderr=subprocess.PIPE, text=True
        )

    return started


def end(process):
    """Exit code and stderr."""
    line = process.communicate()[1]
    return process.returncode, line


@contextlib.contextmanager
def tmpfs(folder, size):
    folder.mkdir()
    command = ["mount", "-t", "tmpfs", "-o", f"size={size}", "tmpfs", str(folder)]
    if subprocess.run(command, check=False, capture_output=True).returncode:
        pytest.skip("mounting a tmpfs needs root")
    try:
        yield folder
    finally:
        subprocess.run(["umount", str(folder)], check=True)


def test_a_full_disk_is_one_line_keeps_the_old_file_and_leaves_no_other(tmp_path, expected, start):
    with tmpfs(tmp_path / "small", "256k") as folder:
        assert end(start(folder, *QUICK, "out=run.nc"))[0] == 0
        before = (folder / "run.nc").read_bytes()
        room = os.statvfs(folder)
        (folder / "filler").write_bytes(bytes(room.f_bavail * room.f_frsize - 8192))
        run = start(folder, *QUICK, "out=run.nc", "log_level=error")
        code, line = end(run)
        assert code == 2
        assert (
            line == "squat: run.nc: cannot be written (No space left on device); "
            "give another out=FILE\n"
        )
        assert (folder / "run.nc").read_bytes() == before
        assert sorted(path.name for path in folder.iterdir()) == ["filler", "run.nc"]
        (folder / "filler").unlink()
        assert end(start(folder, *QUICK, "out=run.nc"))[0] == 0
        assert digest(read_whole(folder / "run.nc")) == expected


def test_read_only_results_are_one_line_and_stay(tmp_path, start):
    with tmpfs(tmp_path / "results", "1m") as folder:
        (folder / "run.nc").write_bytes(b"old")
        subprocess.run(["mount", "-o", "remount,ro", str(folder)], check=True)
        run = start(tmp_path, *QUICK, "out=results/run.nc", "log_level=error")
        code, line = end(run)
        assert code == 2
        assert line.startswith("squat: results/run.nc: cannot be written (")
        assert line.count("\n") == 1
        assert (folder / "run.nc").read_bytes() == b"old"


def test_runs_that_write_the_same_output_leave_one_whole_file(tmp_path, expected, start):
    runs = [start(tmp_path, *QUICK, "out=run.nc") for _ in range(3)]
    codes, lines = zip(*map(end, runs), strict=True)
    assert 0 in codes
    for code, line in zip(codes, lines, strict=True):
        assert code == 0 or (code == 2 and line.endswith(REFUSED)), line
    assert [path.name for path in tmp_path.iterdir()] == ["run.nc"]
    assert digest(read_whole(tmp_path / "run.nc")) == expected


def test_a_run_in_progress_keeps_others_from_its_output_until_it_ends(tmp_path, start):
    job = "-m", *QUICK, "piston.mass_ratio=0.5,2", "hydra.launcher.n_jobs=1"
    sweep = tmp_path / "multirun/piston"
    name = "piston.mass_ratio-{}__time.periods-0.3/piston.nc"
    with claim(tmp_path / "run.nc"), claim(sweep / name.format(2)):
        code, line = end(start(tmp_path, *QUICK, "out=run.nc"))
        assert (code, line) == (2, REFUSED)
        code, lines = end(start(tmp_path, *job))
        assert code == 2
        assert "piston.nc: another run is writing it;" in lines
        assert (sweep / name.format(0.5)).is_file()
        assert list(sweep.rglob("failed.txt")) == []
    assert end(start(tmp_path, *QUICK, "out=run.nc"))[0] == 0
    assert end(start(tmp_path, *job))[0] == 0
    assert [path.name for path in tmp_path.rglob(".*")] == []


def test_a_killed_run_holds_nothing(tmp_path, start):
    source = "import time; from pathlib import Path; from squat.records import claim\n"
    source += "with claim(Path('run.nc')): print(flush=True); time.sleep(600)"
    victim = subprocess.Popen(
        [sys.executable, "-c", source], cwd=tmp_path, stdout=subprocess.PIPE, text=True
    )
    victim.stdout.readline()
    assert end(start(tmp_path, *QUICK, "out=run.nc")) == (2, REFUSED)
    victim.kill()
    victim.communicate()
    assert end(start(tmp_path, *QUICK, "out=run.nc"))[0] == 0
    assert [path.name for path in tmp_path.iterdir()] == ["run.nc"]


def test_an_interrupted_run_says_so_in_one_line_and_goes_on(tmp_path, start):
    words = "task=transient", "mesh=coarse", "accuracy.near=0.4", "restart.pause=0", "out=run.nc"
    words += "restart.interval=2", "time.periods=100", "log_level=warning"
    # Where the tests themselves were started in the background, their children would ignore it.
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    run = start(tmp_path, *words, program=SQUAT)
    signal.signal(signal.SIGINT, before)
    while not list(tmp_path.glob("run.nc.parts/[!.]*")):
        time.sleep(0.05)
        assert run.poll() is None
    run.send_signal(signal.SIGINT)
    code, line = end(run)
    assert (code, line) == (130, "squat: interrupted; the same command goes on from here\n")
    assert [path.name for path in tmp_path.iterdir()] == ["run.nc.parts"]


def test_what_killed_writers_left_is_swept_and_what_others_write_is_not(tmp_path):
    from squat.records import atomic

    leftover = tmp_path / ".run-writing-killed.nc"
    leftover.write_text("half")
    with atomic(tmp_path / "run.nc") as first:
        first.write_text("first")
        with atomic(tmp_path / "run.nc") as second:
            assert sorted(tmp_path.iterdir()) == sorted([first, second])
            second.write_text("second")
        assert first.exists()
    assert [path.name for path in tmp_path.iterdir()] == ["run.nc"]


@pytest.mark.parametrize("shift", [-(10**8), 10**8])
def test_dates_of_files_decide_nothing_in_a_sweep(tmp_path, squat, shift):
    command = "-m", *QUICK, "piston.mass_ratio=0.5,2", "hydra.launcher.n_jobs=1"
    assert squat(*command).returncode == 0
    for path in tmp_path.rglob("*"):
        moment = path.stat().st_mtime + shift
        os.utime(path, (moment, moment))
    again = squat(*command)
    assert again.returncode == 0
    assert again.stderr.count("complete, skipped") == 2


def test_same_bytes_of_physics_with_one_and_two_threads_from_another_folder(tmp_path):
    found = []
    for threads in "12":
        folder = tmp_path / threads
        folder.mkdir()
        environment = {**os.environ, "OMP_NUM_THREADS": threads, "OPENBLAS_NUM_THREADS": threads}
        # A coarse mesh would not tell: its arrays are too small for two threads.
        words = ["task=transient", "current=2.0", "time.periods=0.05", "accuracy.near=0.4"]
        subprocess.run(
            [str(SQUAT), *words, "out=run.nc"], cwd=folder, env=environment, check=True,
            capture_output=True,
        )  # fmt: skip
        found.append(digest(read_whole(folder / "run.nc")))
    assert found[0] == found[1]
