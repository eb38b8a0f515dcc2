"""The last line of the log: an answer with units and errors, in few digits."""

import logging
import math
import re

import pytest

from squat.cli.endings import rounded
from squat.cli.tasks import run_task
from squat.config import compose, validate
from squat.records import read


@pytest.fixture
def said(tmp_path, caplog):
    """Last line of the log of a task, its summary left out, and the record."""

    def run(task, *overrides):
        with caplog.at_level(logging.INFO):
            run_task(validate(compose(task, *overrides)), tmp_path / "out.nc")
        return caplog.records[-1].getMessage().splitlines()[0], read(tmp_path / "out.nc")

    return run


@pytest.mark.parametrize(
    ("value", "error", "words"),
    [
        (2.39978809, 1.01e-6, "2.3998 +- 1e-06"),
        (2.4, 0.0123, "2.400 +- 0.012"),
        (123.456, 7.0, "123.5 +- 7"),
        (866.025, 20.0, "866 +- 20"),
        (0.5, 3.0, "0.5 +- 3"),
        (-4.1e5, 0.0, "-4.1000e+05"),
        (2 / 3, math.inf, "0.66667"),
        (math.nan, 1.0, "none"),
        (0.0, 0.1, "0.0000 +- 0.1"),
    ],
)
def test_no_more_digits_than_the_error_bears_and_five_at_most(value, error, words):
    assert rounded(value, error) == words


def test_added_mass_is_told_over_the_mass_of_the_ship(said):
    line, data = said("added_mass", "mesh=coarse", "accuracy.near=0.4")
    found = re.search(r"ship's mass \((.+) kg/m\): heave (.+) \+- (.+), surge (.+) \+- ", line)
    mass, ratio, error, _ = map(float, found.groups())
    assert mass == pytest.approx(float(data["ship_mass"]), rel=1e-4)
    assert ratio == pytest.approx(float(data["mass_ratio"]), abs=error)


def test_limits_are_told_with_errors_and_where_pitch_is_found(said):
    line, data = said("limits", "accuracy.near=0.4")
    for name, speed, error in zip(
        data["limit"].values, data["limit_speed"].values, data["limit_error"].values, strict=True
    ):
        value, shown = re.search(rf"{name} (\S+) \+- (\S+) m/s", line).groups()
        assert float(value) == pytest.approx(speed, rel=1e-4, abs=error)
        assert float(shown) == pytest.approx(error, rel=0.1)
    assert line.endswith("for heave alone; task=trim for heave and pitch")
