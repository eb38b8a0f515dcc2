"""A graph that is killed again and again ends with the physics of an undisturbed one."""

import os
import shutil

from tests.faults.graph import chain, complete, physics, source

KILLS = int(os.environ.get("SQUAT_KILLS", "5"))
"""`make test-faults` gives 100, over the whole graph."""
WHOLE = KILLS > 5
TARGETS = ["all"] if WHOLE else ["results/tables/table7.csv", "results/piston/standard_2.nc"]
LONGEST = 150.0 if WHOLE else 16.0
"""Seconds after the start of a run, or of its first job, at which it is killed, at most."""


def test_physics_after_kills_is_that_of_an_undisturbed_run(tmp_path, capsys):
    expected = complete(source(tmp_path / "undisturbed"), TARGETS)
    with capsys.disabled():
        met = chain(source(tmp_path / "killed"), TARGETS, KILLS, 4, LONGEST, expected)
        print(f"{met.kills} kills survived over {met.runs} runs, {met.orphans} orphans")
    assert met.kills == KILLS
    assert physics(tmp_path / "killed" / "results") == expected
    shutil.rmtree(tmp_path / "killed")
