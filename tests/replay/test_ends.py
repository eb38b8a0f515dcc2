"""A run that has ended: it stands nowhere while others go on, and its picture says how it ended."""

import pytest
import rerun as rr

from squat import records
from squat.replay.panels import PANELS
from squat.replay.recorder import Recorder
from squat.replay.runs import load
from squat.replay.tube import tube as draw_tube

CLEAR = "is_recursive"


@pytest.fixture(scope="module")
def lost(written):
    """A piston whose first step diverges."""
    return written("lost", "piston", "scheme=standard", "piston.mass_ratio=2")


def names(draw, *paths):
    runs = load(tuple(map(str, paths)))
    return [str(view.name) for view in draw(Recorder(rr.RecordingStream("test")), runs)]


def test_all_that_moves_of_a_run_is_cleared_right_after_its_end(record, entities, lost, tube):
    found = entities(record(lost, tube))
    step = float(records.read(lost)["time_step"])
    clear = found["lost"]
    assert clear.rows[CLEAR] == [[True]] * 2  # once on each axis, with all below
    shown = [time for name, here in found.items() if name.startswith("lost/") for time in here.time]
    last = float(records.read(tube)["time"][-1])
    assert max(shown) + step < clear.time[0] < max(shown) + 0.05 * last  # seen for a moment
    assert len(clear.time) == len(clear.phase) == 1
    assert "tube" not in found  # the longer one stays


def test_runs_that_end_together_and_single_ones_stay(record, entities, lost, tube, tmp_path):
    copy = tmp_path / "copy.nc"
    copy.write_bytes(tube.read_bytes())
    for paths in ((lost,), (tube, copy)):
        assert not any(CLEAR in here.rows for here in entities(record(*paths)).values())


def test_wires_are_sent_in_time_since_what_is_static_cannot_be_cleared(entities, record, ship):
    found = entities(record(ship))
    frames = records.read_group(ship, "fields").sizes["time"]
    zones = [here for name, here in found.items() if name.startswith("channel/wires/")]
    for zone in zones:
        assert len(zone.rows["strips"]) == 1
        assert len(zone.time) == frames + 1  # a row of lines, and one of motion for each frame
    assert zones


def test_pictures_say_how_and_when_runs_ended(lost, tube):
    first, other = names(draw_tube, lost, tube)
    last = float(records.read(tube)["time"][-1])
    failed = float(records.read(lost)["time_step"])
    assert first.endswith(f"; diverged in the step to {failed:.4g} s")
    assert other.endswith(f"; ends at {last:.4g} s")
    assert names(draw_tube, lost)[0].endswith(f"; diverged in the step to {failed:.4g} s")
    assert "ends" not in names(draw_tube, tube)[0]


def test_differences_from_a_run_without_a_step_say_why_they_are_empty(lost, tube):
    draw = PANELS["iterations differences"].draw
    assert names(draw, lost, tube) == ["Δ Iterations of a step: no common step"]
    assert names(draw, tube, lost) == ["Δ Iterations of a step: no common step"]


def test_of_several_runs_the_one_without_a_step_is_named(lost, tube, tmp_path):
    copy = tmp_path / "copy.nc"
    copy.write_bytes(tube.read_bytes())
    (title,) = names(PANELS["iterations differences"].draw, tube, copy, lost)
    assert title == "Δ Iterations of a step, less tube; no common step with lost"


def test_residuals_are_said_to_be_red_where_a_step_failed(lost, tube):
    draw = PANELS["residuals"].draw
    assert names(draw, tube) == ["Residuals of the step"]
    assert names(draw, lost) == ["Residuals of the step; red: of the one that failed"]
