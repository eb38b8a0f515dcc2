"""The example of the documentation, without a screen."""

import importlib.util
import re
import subprocess
import sys

import pytest

from squat import records
from squat.config import compose, validate
from squat.reduced import run


@pytest.fixture(scope="module")
def model(tmp_path_factory):
    config = compose("reduced", "mesh=coarse", "reduced.positions=10")
    dataset, groups = run(validate(config).case)
    path = tmp_path_factory.mktemp("example") / "model.nc"
    records.save(dataset, path, config, 0.0, groups)
    return path


def test_example_streams_a_recording_and_is_faster_than_real_time(root, model, tmp_path):
    script, out = root / "docs" / "examples" / "simulator.py", tmp_path / "run.rrd"
    command = [sys.executable, str(script), str(model), "--save", str(out)]
    done = subprocess.run(command, capture_output=True, text=True, timeout=120, check=False)
    assert done.returncode == 0, done.stderr
    assert int(re.search(r"(\d+) times faster", done.stdout)[1]) > 1
    from rerun.chunk import RrdReader

    paths = {chunk.entity_path for chunk in RrdReader(str(out)).stream()}
    assert {"/ship/heave", "/ship/clearance", "/water/current"} <= paths


def test_example_ends_where_the_simulator_does_without_a_stream(root, model):
    spec = importlib.util.spec_from_file_location("e", root / "docs" / "examples" / "simulator.py")
    example = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(example)
    state, _ = example.run(str(model), None, live=False)
    assert state.time == pytest.approx(example.DURATION)
    assert not state.grounded
    assert state.heave < -0.5  # the faster current has drawn it down
    assert example.run(str(model), None, live=False)[0] == state


def test_example_says_in_one_line_what_is_wrong_with_a_file(root, tmp_path):
    script = root / "docs" / "examples" / "simulator.py"
    command = [sys.executable, str(script), str(tmp_path / "absent.nc")]
    done = subprocess.run(command, capture_output=True, text=True, timeout=120, check=False)
    assert done.returncode == 2
    assert len(done.stderr.splitlines()) == 1
    assert "absent.nc" in done.stderr
