"""The page of a run names its choices, its hull by shape only where nothing better is known."""

import json

from squat import records
from squat.replay.case_text import page
from squat.replay.runs import Run


def test_hull_and_coupling_are_named_as_they_were_chosen(ship):
    data = records.read(ship)
    chosen = data.assign_attrs(choices=json.dumps({"hull": "feeder", "coupling": "mine"}))
    assert "| length L (feeder) | 40 m |" in page(Run("", ship, chosen, None))
    assert "| coupling | mine (corrected) |" in page(Run("", ship, chosen, None))
    del data.attrs["choices"]
    assert "| length L (rectangle) | 40 m |" in page(Run("", ship, data, None))
    assert "| coupling | printed (corrected) |" in page(Run("", ship, data, None))
