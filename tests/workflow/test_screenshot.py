"""The picture of a recording: what is typed, and a viewer that cannot draw."""

import subprocess
import sys
from pathlib import Path
from types import SimpleNamespace

import pytest
from rerun.experimental import Timeline

from workflows import screenshot


def test_usage_tells_that_the_moment_is_sim_time_in_seconds(root, tmp_path):
    command = [sys.executable, str(root / "workflows/screenshot.py")]
    shown = subprocess.run([*command, "--help"], capture_output=True, text=True, check=True)
    assert "RECORDING PNG SIM_TIME" in shown.stdout
    assert "sim_time in s" in shown.stdout
    absent = [*command, "no.rrd", "out.png", "8"]
    done = subprocess.run(absent, capture_output=True, text=True, check=False, cwd=tmp_path)
    assert done.returncode == 2
    assert "no.rrd: no such file; squat task=replay makes one" in done.stderr
    assert list(tmp_path.iterdir()) == []
    (tmp_path / "run.nc").write_bytes(b"\x89HDF")
    (tmp_path / "run.rrd").write_bytes(b"RRF2")
    for given, said in (
        (("run.nc", "out.png"), "run.nc: no recording; squat task=replay makes one"),
        (("run.rrd", "no/out.png"), "no/out.png: no such folder; make it, or give another"),
    ):
        done = subprocess.run(
            [*command, *given, "8"], capture_output=True, text=True, check=False, cwd=tmp_path
        )
        assert done.returncode == 2
        assert said in done.stderr


def test_a_moment_beyond_the_end_is_refused_with_the_end(tmp_path, monkeypatch):
    monkeypatch.setattr(screenshot, "_SETTLING", 0.0)
    timelines = [Timeline("sim_time", "duration", 0, 7_500_000_000)]
    state = SimpleNamespace(recordings=[SimpleNamespace(timelines=timelines)])
    client = SimpleNamespace(open=lambda path: None, get_state=lambda: state)
    with pytest.raises(SystemExit, match=r"SIM_TIME=8: run\.rrd ends at 7\.5 s"):
        screenshot._draw(client, Path("run.rrd"), tmp_path / "out.png", 8.0)


@pytest.mark.parametrize("told", [41.079, 41.08, 41.0789])
def test_the_end_as_it_is_told_is_the_end(tmp_path, monkeypatch, told):
    monkeypatch.setattr(screenshot, "_SETTLING", 0.0)
    timelines = [Timeline("sim_time", "duration", 0, 41_078_959_400)]
    state = SimpleNamespace(recordings=[SimpleNamespace(timelines=timelines)], views=[])
    shown = []
    client = SimpleNamespace(
        open=lambda path: None,
        get_state=lambda: state,
        set_time=lambda line, duration, play_state: shown.append(duration),
        save_screenshot=lambda path: None,
    )
    assert screenshot._draw(client, Path("run.rrd"), tmp_path / "out.png", told) == []
    assert shown == [pytest.approx(41.0789594, rel=1e-12)]


def test_what_the_viewer_says_is_shown_only_where_it_fails(tmp_path, monkeypatch, capfd):
    viewer = tmp_path / "viewer"
    viewer.write_text("#!/bin/sh\necho chatter\necho no driver >&2\nexit 3\n")
    viewer.chmod(0o755)
    monkeypatch.setattr(screenshot, "_VIEWER", viewer)
    with pytest.raises(SystemExit) as caught:
        screenshot.main(tmp_path / "run.rrd", tmp_path / "out.png", 8.0)
    assert str(caught.value).startswith("chatter\nno driver\n")
    assert str(caught.value).endswith("run.rrd: the viewer failed; it needs a Vulkan driver")
    assert capfd.readouterr() == ("", "")
    assert not (tmp_path / "out.png").exists()
