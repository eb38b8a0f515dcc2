"""The last words of the log: an answer with units and errors."""

import logging
import re

import pytest

from squat.cli.tasks import remarks, run_task
from squat.config import compose, validate
from squat.records import read


@pytest.fixture
def said(tmp_path, caplog):
    """What the log says last of a task, and the record."""

    def run(task, *overrides):
        with caplog.at_level(logging.INFO):
            run_task(validate(compose(task, *overrides)), tmp_path / "out.nc")
        return caplog.records[-1].getMessage(), read(tmp_path / "out.nc")

    return run


def test_added_mass_is_told_over_the_mass_of_the_ship(said):
    line, data = said("added_mass", "mesh=coarse", "accuracy.near=0.4")
    found = re.search(
        r"ship's mass \((.+) kg/m\): heave (.+) \+- (\S+) \(on the given mesh (.+)\), surge ", line
    )
    mass, ratio, error, coarse = map(float, found.groups())
    heave = {"mode_i": "heave", "mode_j": "heave"}
    assert coarse == pytest.approx(float(data["added_mass_mesh"].sel(heave)) / mass, rel=1e-4)
    assert mass == pytest.approx(float(data["ship_mass"]), rel=1e-4)
    assert ratio == pytest.approx(float(data["mass_ratio"]), abs=error)


def test_a_mesh_is_told_by_its_size_and_its_worst_triangle(said, caplog):
    line, data = said("mesh", "mesh=coarse", "hull=lewis")
    words = r", (\d+) nodes, (\d+) triangles, least quality (\S+) at rest, (\S+) moved$"
    nodes, triangles, *worst = map(float, re.search(words, line).groups())
    assert (nodes, triangles) == (data.sizes["node"], data.sizes["face"])
    for told, name in zip(worst, ("face_quality", "moved_quality"), strict=True):
        assert told == pytest.approx(float(data[name].min()), rel=0.05)
    assert not [record for record in caplog.records if record.levelno >= logging.WARNING]


@pytest.mark.parametrize(("surface", "count"), [("rigid_lid", 1), ("zero_pressure", 0)])
def test_a_channel_that_is_short_ahead_is_remarked_on_once_and_under_the_lid_alone(
    said, caplog, surface, count
):
    quick = "mesh=coarse", "accuracy.near=0.8", "hull.length=60.0"
    said("added_mass", *quick, f"free_surface={surface}")
    lines = [record.getMessage() for record in caplog.records]
    assert sum("channel.upstream=40: short" in line for line in lines) == count


@pytest.mark.parametrize("task", ["race", "trim"])
def test_tasks_that_know_the_lid_alone_remark_on_it_too(task):
    case = validate(compose(task, "hull.length=60.0")).case
    assert any("channel.upstream=40: short" in line for line in remarks(case))


def test_limits_are_told_with_errors_and_where_pitch_is_found(said):
    text, data = said("limits", "accuracy.near=0.4")
    for name, speed, error in zip(
        data["limit"].values, data["limit_speed"].values, data["limit_error"].values, strict=True
    ):
        value, shown = re.search(rf"  {name} +(\S+) \+- (\S+) m/s", text).groups()
        assert float(value) == pytest.approx(speed, rel=1e-7, abs=error)
        assert float(shown) == pytest.approx(error, rel=0.1)
    assert "limits in heave alone (task=trim gives those in heave and pitch)" in text


def test_the_limit_along_a_hull_is_told_where_it_is_not_the_box_s(said):
    text, data = said("limits", "hull=v", "accuracy.near=0.8")
    local = float(data["limit_local"])
    assert local > 1.2 * float(data["limit_speed"].sel(limit="1D"))
    assert f"1D along the hull     {local:.6g} m/s" in text
    text, data = said("limits", "accuracy.near=0.8")
    box = float(data["limit_speed"].sel(limit="1D"))
    assert float(data["limit_local"]) == pytest.approx(box, rel=1e-6)
    assert "along the hull" not in text
