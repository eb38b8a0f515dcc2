"""What tests keep of Hydra's work changes nothing that is composed."""

import os

from squat.config.compose import composed
from squat.errors import InputError
from tests.kept import FOLDER

CASES = [
    ("transient", "mesh=coarse", "current=2"),
    ("transient", "mesh=coarse", "current=3"),
    ("transient", "hull=lewis", "hull.draft=9"),
    ("transient", "hull=lewis"),
    ("transient", "coupling=newmark", "accelerator@coupling.accelerator=monolithic"),
    ("inertia", "cases/inertia@cells=table4_small"),
    ("trim", "cases/trim@_global_=small"),
    ("piston", "~piston.mass_ratio"),
    ("piston", "+no=1"),
    ("piston", "no=1"),
    ("transient", "hull=no"),
]


def made():
    for case in CASES:
        try:
            yield composed(*case)
        except InputError as error:
            yield str(error)


def test_kept_choices_of_groups_compose_as_fresh_ones(monkeypatch):
    kept_once, kept = list(made()), list(made())
    assert os.environ[FOLDER]
    monkeypatch.delenv(FOLDER)
    fresh = list(made())
    assert kept_once == kept == fresh
    assert sum(isinstance(one, str) for one in fresh) == 2
