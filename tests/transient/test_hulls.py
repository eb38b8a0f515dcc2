"""Every ready-made hull through the whole coupled run, in heave and pitch."""

import numpy as np
import pytest

from squat import transient
from squat.config import compose, validate
from tests.hulls import NAMES

KEYS = (
    "mesh=coarse", "mesh.near=2", "mesh.far=6", "accuracy.near=0.8", "current=1.5",
    "time.periods=0.04", "modes=[heave,pitch]", "initial_pitch=0.002",
    "coupling=energy_momentum", "force=variational",
)  # fmt: skip


@pytest.mark.parametrize("name", NAMES)
def test_every_hull_runs_coupled_and_keeps_its_energy_to_rounding(name):
    data, _ = transient.run(validate(compose("transient", f"hull={name}", *KEYS)).case)
    assert data.attrs["status"] == "completed"
    assert np.abs(np.diff(data["pitch"].values)).max() > 0
    scale = float(data["ship_mass"]) * 9.81 * 10
    assert np.abs(data["energy_residual"].values).max() < 1e-11 * scale
