"""Datasets of the paper's sections, computed once."""

import json

import pytest

from squat import transient
from squat.analysis.claims import Sources
from squat.config import compose, validate
from squat.fluid import inertia
from squat.fluid import run as added_mass
from squat.piston import study
from squat.stability import limits
from squat.stability.run import run
from squat.trim import run as trim


def computed(function, task, *overrides):
    valid = validate(compose(task, *overrides))
    return function(valid.case).assign_attrs(config=json.dumps(valid.config))


RUNS = [
    *((name, speed) for name in ("printed", "printed_standard") for speed in (1, 2, 2.25, 2.5)),
    ("printed_euler", 1, "time.periods=0.5"),
    ("printed_backward", 1),
]


FREED = "modes=[heave,pitch]", "initial_pitch=0.001", "time.periods=0.5"


def coupled(coupling, speed, *more):
    overrides = (
        "mesh=coarse",
        "accuracy.near=0.4",
        f"coupling={coupling}",
        f"current={speed}",
        *more,
    )
    return computed(lambda case: transient.run(case).dataset, "transient", *overrides)


@pytest.fixture(scope="session")
def sources():
    cells = "cases/inertia@cells="
    return Sources(
        iterations=computed(study, "iterations"),
        equilibria=computed(run, "equilibria"),
        table4=computed(inertia.run, "inertia", f"{cells}table4_small", "accuracy=study"),
        table5=computed(inertia.run, "inertia", f"{cells}table5_small", "accuracy=study"),
        table6=computed(added_mass.run, "added_mass"),
        limits=computed(limits.run, "limits", "accuracy=study"),
        trim=computed(trim.run, "trim", "cases/trim@_global_=small"),
        transients=tuple(coupled(*one) for one in RUNS),
        pitching=tuple(coupled(name, 2.25, *FREED) for name in ("printed", "consistent")),
    )
