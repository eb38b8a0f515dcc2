"""Reduced models of small ships, made once."""

import numpy as np
import pytest

from squat.config import compose, validate
from squat.fluid.potential import PotentialFluid
from squat.reduced.record import Loaded
from squat.reduced.run import make

HEAVE = ("mesh=coarse",)
PITCH = ("mesh=coarse", "mesh.near=2", "mesh.far=6", "reduced=heave_pitch", "reduced.positions=16")


class Pair:
    """A reduced model and the full one on the same mesh."""

    def __init__(self, *overrides):
        self.case = validate(compose("reduced", *overrides)).case
        made, self.mesh = make(self.case)
        self.made, self.model = made, made.model
        self.loaded = Loaded(made.model, self.mesh, made.basis)

    def full(self, current=0.0):
        return PotentialFluid(self.mesh, self.case.water, self.case.free_surface, current)

    def positions(self, count=200, seed=1):
        return self.model.box.random(count, seed)


@pytest.fixture(scope="session")
def pair():
    kept = {}

    def found(*overrides):
        if overrides not in kept:
            kept[overrides] = Pair(*overrides)
        return kept[overrides]

    return found


@pytest.fixture(scope="session")
def heave(pair):
    return pair(*HEAVE)


@pytest.fixture(scope="session")
def pitch(pair):
    return pair(*PITCH)


@pytest.fixture
def at():
    return lambda *q: np.array(q, float)
