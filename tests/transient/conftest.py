"""Small ships: the case of section 3.6 on a coarse mesh."""

import numpy as np
import pytest

from squat.config import compose, validate
from squat.transient.parts import prepare


@pytest.fixture(scope="session")
def ship():
    """The case of `squat task=transient mesh=coarse <overrides>`."""

    def make(*overrides):
        return validate(compose("transient", "mesh=coarse", "accuracy.near=0.4", *overrides)).case

    return make


@pytest.fixture(scope="session")
def fluid(ship):
    """Fluid of such a case."""
    return lambda *overrides: prepare(ship(*overrides)).fluid


@pytest.fixture
def at():
    return lambda w: np.array([float(w)])
