"""A run that is killed at any moment and started again gives the bytes of an undisturbed one."""

import json
import os
import re
import shutil
import signal
import subprocess
import sys
import time
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from squat.config import compose, validate
from squat.coupling import State
from squat.dynamics import Motion
from squat.fluid.rates import Levels
from squat.fluid.run import run as added_mass
from squat.mesh.run import run as make_mesh
from squat.records import Segments, read, read_group, save, strict_identity
from squat.records.provenance import digest
from squat.records.trees import copy, flatten, rebuild
from squat.transient.ending import Ending
from squat.transient.parts import prepare
from squat.transient.run import run

KILLS = 20
CHAIN = ("current=2", "time.periods=4", "restart.interval=5", "restart.pause=0", "snapshots=20")
DRIVER = """
import os, random, signal, sys, time
from pathlib import Path
from squat.config import compose, validate
from squat.records import Segments, save, strict_identity
from squat.transient.run import run

out, kills, overrides = Path(sys.argv[1]), int(sys.argv[2]), sys.argv[3:]
chance = random.Random(20)

def whole():
    config = compose("transient", *overrides)
    segments = Segments.beside(out, strict_identity(config))
    result = run(validate(config).case, segments)
    save(result.dataset, out, config, 0.0, {"fields": result.fields})
    os._exit(0)

def segments():
    return len(list(Path(f"{out}.parts").glob("[!.]*.npz")))

for _ in range(kills):
    wanted = segments() + chance.randrange(4)
    child = os.fork()
    if child == 0:
        whole()
    while segments() < wanted and os.waitpid(child, os.WNOHANG) == (0, 0):
        time.sleep(0.002)
    time.sleep(chance.uniform(0, 0.1))
    os.kill(child, signal.SIGKILL)
    assert os.waitpid(child, 0)[1] == signal.SIGKILL, "ended before it was killed"
    assert not out.exists()
    print(segments())
child = os.fork()
if child == 0:
    whole()
assert os.waitpid(child, 0)[1] == 0
"""


@pytest.fixture(scope="module")
def made(tmp_path_factory):
    """Overrides that take mesh and added mass from files."""
    folder = tmp_path_factory.mktemp("made")
    for task, make, name, *given in (
        ("mesh", make_mesh, "mesh", "mesh=coarse"),
        ("added_mass", added_mass, "added", "accuracy.near=0.4", "free_surface=zero_pressure"),
    ):
        config = compose(task, *given)
        save(make(validate(config).case), folder / f"{name}.nc", config, 0.0)
    files = (f"inputs.mesh={folder}/mesh.nc", f"inputs.added_mass={folder}/added.nc")
    return "mesh=coarse", *files


def shorter(made, folder, *overrides):
    """Case and segments in `folder` of a run of 14 steps with segments of 3."""
    given = "time.periods=0.2", "restart.interval=3", "restart.pause=0", *overrides
    config = compose("transient", *made, "current=2", *given)
    return validate(config).case, Segments(folder / "r.nc.parts", strict_identity(config))


@pytest.fixture
def short(made, tmp_path):
    return lambda *overrides: shorter(made, tmp_path, *overrides)


@pytest.fixture(scope="module")
def undisturbed(made, tmp_path_factory):
    """Folder of the segments that such a run leaves, and the digest of its values."""
    case, segments = shorter(made, tmp_path_factory.mktemp("undisturbed"))
    return segments.folder, digest(run(case, segments).dataset)


def test_killed_at_twenty_moments_equals_undisturbed(made, tmp_path):
    out = tmp_path / "run.nc"
    arguments = [sys.executable, "-c", DRIVER, str(out), str(KILLS), *made, *CHAIN]
    done = subprocess.run(arguments, capture_output=True, text=True, check=False, timeout=200)
    assert done.returncode == 0, done.stderr
    counts = [int(line) for line in done.stdout.split()]
    assert len(counts) == KILLS
    assert counts == sorted(counts)  # nothing is lost
    assert len(set(counts)) > KILLS / 4  # and the run goes on from where it was
    undisturbed = run(validate(compose("transient", *made, *CHAIN)).case)
    survivor = read(out)
    for name, variable in undisturbed.dataset.variables.items():
        assert variable.values.tobytes() == survivor[name].values.tobytes(), name
    assert survivor.attrs["content_sha256"] == digest(undisturbed.dataset)
    assert read_group(out, "fields").identical(undisturbed.fields)


def test_the_killed_command_goes_on_and_leaves_one_file(made, tmp_path, squat):
    given = *made, *CHAIN, "time.periods=2"
    command = ["task=transient", *given, "out=run.nc"]
    parts = tmp_path / "run.nc.parts"
    victim = subprocess.Popen(
        [str(Path(sys.executable).parent / "squat"), *command],
        cwd=tmp_path,
        stderr=subprocess.DEVNULL,
        env={**os.environ, "OMP_NUM_THREADS": "1"},
    )
    while len(list(parts.glob("[!.]*.npz"))) < 2:
        time.sleep(0.01)
        assert victim.poll() is None
    victim.send_signal(signal.SIGKILL)
    victim.wait()
    done = squat(*command)
    assert done.returncode == 0, done.stderr
    assert "run.nc: going on from step" in done.stderr
    assert [path.name for path in tmp_path.iterdir()] == ["run.nc"]
    undisturbed = run(validate(compose("transient", *given)).case).dataset
    assert read(tmp_path / "run.nc").attrs["content_sha256"] == digest(undisturbed)


@pytest.mark.parametrize("harm", ["truncate", "flip", "empty", "text", "remove"])
@pytest.mark.parametrize("which", [0, 2])
def test_a_damaged_segment_is_noticed_and_done_again(short, undisturbed, caplog, harm, which):
    case, segments = short()
    left, expected = undisturbed
    shutil.copytree(left, segments.folder)
    files = sorted(segments.folder.iterdir())
    assert len(files) == 4
    whole = bytearray(files[which].read_bytes())
    middle = slice(len(whole) // 2, len(whole) // 2 + 512)  # more than a header is long
    whole[middle] = bytes(255 - byte for byte in whole[middle])
    {
        "truncate": lambda: os.truncate(files[which], len(whole) // 2),
        "flip": lambda: files[which].write_bytes(whole),
        "empty": lambda: os.truncate(files[which], 0),
        "text": lambda: files[which].write_text("no archive"),
        "remove": files[which].unlink,
    }[harm]()
    with caplog.at_level("INFO"):
        assert digest(run(case, segments).dataset) == expected
    assert ("broken" in caplog.text) == (harm != "remove")
    assert ("going on from step 6 of 14" in caplog.text) == (which == 2)


@pytest.mark.parametrize(
    "overrides",
    [
        ("coupling=consistent_quasi_newton",),
        ("coupling=consistent", "accelerator@coupling.accelerator=anderson"),
        ("coupling=newmark", "accelerator@coupling.accelerator=monolithic"),
        ("coupling=consistent", "force=variational"),
        ("coupling=energy_momentum", "force=variational"),
        ("modes=[heave,pitch]", "coupling=consistent"),
        ("coupling=energy_momentum", "force=variational", "model=curves"),
        ("model=reduced",),
    ],
)
def test_every_scheme_goes_on_from_a_segment_with_the_same_bytes(short, caplog, overrides):
    case, segments = short(*overrides)
    expected = digest(run(case, segments).dataset)
    for later in sorted(segments.folder.iterdir())[2:]:
        later.unlink()
    with caplog.at_level("INFO"):
        assert digest(run(case, segments).dataset) == expected
    assert "going on from step 6 of 14" in caplog.text


def test_segments_of_another_run_are_set_aside_for_that_one(short, caplog):
    case, segments = short()
    expected = digest(run(case, segments).dataset)
    other, others = short("current=2.1", "grounding=0.06")
    with caplog.at_level("INFO"):
        assert digest(run(other, others).dataset) == digest(run(other).dataset)
    told = (
        r"left by another run \((current|grounding)=.* in place of .*, .* in place of .*\); kept as"
    )
    assert re.search(told, caplog.text)
    assert "going on" not in caplog.text
    older = replace(others, make={**others.make, "code": "another"})
    assert list(older.read()) == []
    assert not older.folder.exists()
    with caplog.at_level("INFO"):
        assert digest(run(case, segments).dataset) == expected
    assert "going on from step 12 of 14" in caplog.text
    assert len(list(others.read())) == 4  # that one's are still there too
    segments.clear()
    assert len(list(segments.read())) == 4


def test_bytes_do_not_depend_on_the_time_between_segments(short):
    case, segments = short()
    seldom = replace(case, restart=replace(case.restart, pause=1e6))
    assert digest(run(case, segments).dataset) == digest(run(seldom, segments).dataset)
    segments.clear()
    assert digest(run(case).dataset) == digest(run(seldom, segments).dataset)
    assert not segments.folder.exists()


def test_anything_that_a_run_remembers_comes_back_bit_for_bit():
    motion = Motion(np.array([0.1]), np.array([-0.0]), np.array([np.nan]))
    memory = Levels(np.arange(6.0).reshape(2, 3), np.asfortranarray(np.eye(3)), np.empty(0))
    state = State((motion, motion), {"levels": memory, "counts": [1, None, True, 1e-300, "a"]})
    for back in (copy(state), rebuild(*map(json_and_arrays, flatten(state)))):
        assert type(back) is State
        assert type(back.memory["levels"]) is Levels
        assert back.memory["counts"] == state.memory["counts"]
        assert back.motion.velocity.tobytes() == motion.velocity.tobytes()
        assert back.motion.acceleration.tobytes() == motion.acceleration.tobytes()
        assert np.array_equal(back.memory["levels"].now, memory.now)
    with pytest.raises(TypeError, match="not data"):
        flatten(State((motion,), lambda: None))
    with pytest.raises(ValueError, match="not one of squat's"):
        rebuild({"class": "os:system", "fields": {"command": {"value": ""}}}, [])


def json_and_arrays(part):
    return part if isinstance(part, list) else json.loads(json.dumps(part))


@pytest.mark.parametrize("interval", [3, 0])
def test_a_full_disk_is_one_line_and_nothing_half_written(made, tmp_path, interval):
    squat = Path(sys.executable).parent / "squat"
    words = [*made, "time.periods=0.2", f"restart.interval={interval}", "restart.pause=0"]
    limited = ["bash", "-c", 'ulimit -f 16; exec "$0" "$@"', str(squat), "task=transient", *words]
    # Python would cut its own bytecode short at the limit, and trip over it ever after.
    done = subprocess.run(
        [*limited, "out=run.nc", "log_level=warning"],
        cwd=tmp_path, capture_output=True, text=True, check=False, timeout=60,
        env={**os.environ, "PYTHONDONTWRITEBYTECODE": "1"},
    )  # fmt: skip
    assert done.returncode == 2
    assert done.stderr.startswith("squat: run.nc")
    assert "cannot be written (File too large)" in done.stderr
    assert done.stderr.count("\n") == 1
    assert [path for path in tmp_path.rglob("*") if path.is_file()] == []


def test_turning_point_ends_a_run_that_is_otherwise_the_same(short):
    until = "time.until=end", "time.until=turn"
    whole, turned = (run(short("current=1", "time.periods=1.5", u)[0]).dataset for u in until)
    assert whole.attrs["status"] == "completed"
    assert turned.attrs["status"] == "turned"
    velocity = turned["heave_velocity"].values
    assert velocity[-1] > 0
    assert (velocity[1:-1] < 0).all()  # from rest above the equilibrium, down first
    count = turned.sizes["time"]
    assert turned["heave"].values.tobytes() == whole["heave"].values[:count].tobytes()


def test_unresolved_velocities_are_no_turning_point(short):
    case, _ = short("time.until=turn")
    ending = replace(Ending.of(case, prepare(case)), resolved=1e-6)
    for velocity in (1e-7, -1e-7, 5e-7, -9e-7):
        ending.see(np.array([-0.1]), np.array([velocity]))
    assert ending.status is None
    ending.see(np.array([-0.1]), np.array([2e-6]))
    ending.see(np.array([-0.1]), np.array([-1e-9]))
    assert ending.status == "turned"
