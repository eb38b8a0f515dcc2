"""Answers of tasks in words, and the starts of the map that they lead to."""

import re
from types import SimpleNamespace

import numpy as np
import pytest

from squat.cli.tasks import compute
from squat.config import compose, validate
from squat.stability.briefs import hull_shapes


@pytest.mark.parametrize(
    ("task", "quick", "named"),
    [
        ("stability", ("mesh=coarse",), ("squat_speed_2d", "dynamic_squat_speed")),
        (
            "hull_shapes",
            ("cases/hull_shapes@_global_=small", "accuracy.near=0.8"),
            ("limit_2d", "block_coefficient"),
        ),
        (
            "uneven_bottom",
            ("accuracy.near=0.8", "places=[0]", "steepness=[0.5]", "gaps=[0.1]", "rises=[2]"),
            ("squat_speed", "force"),
        ),
    ],
)
def test_tasks_of_limits_tell_their_numbers(task, quick, named):
    data = compute(validate(compose(task, *quick)))
    text = data.attrs["summary"]
    told = [float(word) for word in re.findall(r"-?\d+\.\d+(?:e[+-]\d+)?", text)]
    for name in named:
        for value in np.ravel(data[name].values):
            assert any(abs(number - value) <= 0.006 * abs(value) for number in told), name


def test_heads_stand_over_their_columns():
    data = {
        "hull": ["v", "rectangle"],
        "current": 1.0,
        "block_coefficient": [0.5, 1.0],
        **{name: [1.0, 2.0] for name in ("limit_2d", "limit_dynamic", "equilibrium")},
        **{f"{name}_error": [0.1, 0.1] for name in ("limit_2d", "limit_dynamic", "equilibrium")},
    }
    head, *rows = hull_shapes(data).split("\n")
    for row in rows:
        cells = [row.index("0.5" if row.strip().startswith("v") else "1.0")]
        cells += [found.start() for found in re.finditer(r"\S+ \+-", row)]
        heads = [head.index(word) for word in ("C_B", "2D limit", "dynamic", "w at")]
        assert cells == heads


def test_starts_that_are_not_given_lie_between_ground_and_top_and_begin_at_rest():
    portrait = validate(compose("stability", "portrait=own", "portrait.velocities.least=null"))
    ends = SimpleNamespace(low=-8.0, high=5.0)
    heaves, velocities = portrait.case.portrait.starts(ends, 2 * np.pi)
    shares, share = portrait.case.portrait.heave_shares, portrait.case.portrait.velocity_share
    assert heaves[[0, -1]] == pytest.approx([shares[0] * -8.0, shares[1] * 5.0], rel=0.1)
    assert velocities[0] == 0.0
    assert velocities[-1] == pytest.approx(share * 8.0, rel=0.1)
