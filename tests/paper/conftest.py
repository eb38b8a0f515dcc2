"""Datasets of the paper's sections, computed once."""

import json

import pytest

from squat.analysis.claims import Sources
from squat.config import compose, validate
from squat.piston import study
from squat.stability.run import run


def computed(function, task, *overrides):
    valid = validate(compose(task, *overrides))
    return function(valid.case).assign_attrs(config=json.dumps(valid.config))


@pytest.fixture(scope="session")
def sources():
    return Sources(computed(study, "iterations"), computed(run, "equilibria"))
