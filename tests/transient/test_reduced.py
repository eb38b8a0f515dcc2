"""Runs on the reduced model: the full mesh's history, record and field, whatever the scheme."""

import numpy as np
import pytest

from squat import records
from squat.config import compose
from squat.errors import InputError
from squat.reduced import run as make
from squat.transient.run import run

MODELS = ("full", "reduced")
SAME = 1e-7
"""m: promised for w(t)."""
COMMON = ("current=2", "time.periods=0.4", "coupling.criterion.tolerance=1e-10")


@pytest.mark.parametrize(
    "keys",
    [
        ("coupling=printed",),
        ("coupling=newmark", "free_surface=blend"),
        ("coupling=consistent",),
        ("coupling=consistent", "force=variational"),
        ("coupling=energy_momentum", "force=variational"),
        ("coupling=printed", "free_surface=zero_pressure", "current=0", "initial_heave=-2"),
    ],
)
def test_reduced_run_is_the_full_one(ship, keys):
    full, reduced = (run(ship(*COMMON, *keys, f"model={m}")).dataset for m in MODELS)
    assert full.attrs["status"] == reduced.attrs["status"] == "completed"
    assert float(abs(full["heave"] - reduced["heave"]).max()) < SAME
    assert set(full.variables) == set(reduced.variables)
    pressure = abs(full["hull_pressure"] - reduced["hull_pressure"]).max()
    assert float(pressure / abs(full["hull_pressure"]).max()) < 1e-6


@pytest.mark.parametrize(
    "how",
    [
        ("force=variational", "coupling=energy_momentum", "current=1", "reduced.positions=20"),
        ("coupling=printed", "current=2"),
    ],
)
def test_reduced_run_with_pitch_is_the_full_one(ship, how):
    """By energies, second order in the field's error, and by pressure, first order."""
    keys = ("modes=[heave,pitch]", "initial_pitch=0.001", "reduced=heave_pitch", "mesh.near=2")
    keys = (*keys, *how, "mesh.far=6", "time.periods=0.15")
    full, reduced = (run(ship(*keys, f"model={m}")).dataset for m in MODELS)
    half_length = 20.0
    assert float(abs(full["heave"] - reduced["heave"]).max()) < SAME
    assert float(abs(full["pitch"] - reduced["pitch"]).max()) * half_length < SAME


def test_a_ship_that_trims_beyond_the_model_ends_by_name(ship):
    keys = ("modes=[heave,pitch]", "initial_pitch=0.0185", "current=0", "reduced=heave_pitch")
    size = ("mesh.near=2", "mesh.far=6", "reduced.positions=6", "reduced.tolerance=1e-3")
    data = run(ship(*keys, *size, "model=reduced")).dataset
    assert data.attrs["status"] == "overtrimmed"


def test_run_that_diverges_or_grounds_does_so_on_the_reduced_model(ship):
    failed = run(ship("current=1", "coupling=printed_standard", "model=reduced")).dataset
    assert failed.attrs["status"] == "diverged"
    keys = "current=3", "force=variational", "coupling=energy_momentum"
    sunk = run(ship("model=reduced", "time.steps_per_period=1000", *keys)).dataset
    assert sunk.attrs["status"] == "grounded"
    assert float(sunk["heave"][-1]) < -9.8


@pytest.fixture(scope="module")
def file(tmp_path_factory):
    from squat.config import validate

    config = compose("reduced", "mesh=coarse", "fields=true")
    dataset, groups = make(validate(config).case)
    path = tmp_path_factory.mktemp("model") / "reduced.nc"
    records.save(dataset, path, config, 0.0, groups)
    return path


def test_snapshots_of_a_stored_model_are_those_of_the_full_mesh(ship, file):
    keys = (*COMMON, "snapshots=7", "time.periods=0.2")
    full = run(ship(*keys)).fields
    reduced = run(ship(*keys, "model=reduced", f'inputs.reduced="{file}"')).fields
    assert full.sizes == reduced.sizes
    for name in ("x", "z", "potential", "pressure"):
        apart = float(abs(full[name] - reduced[name]).max() / abs(full[name]).max())
        assert apart < 1e-6  # float32 has 6e-8


def test_model_of_another_mesh_is_refused_by_name(ship, file):
    with pytest.raises(InputError, match=r"inputs\.reduced=.*another mesh"):
        run(ship("model=reduced", "mesh.near=1.5", f'inputs.reduced="{file}"'))


def test_model_that_would_go_unused_is_refused(ship):
    with pytest.raises(InputError, match=r"^inputs.reduced=model.nc: model=full .*model=reduced$"):
        ship("inputs.reduced=model.nc")


def test_history_does_not_depend_on_who_made_the_model(ship, file):
    keys = (*COMMON, "model=reduced")
    stored = run(ship(*keys, f'inputs.reduced="{file}"')).dataset
    fresh = run(ship(*keys)).dataset
    assert np.array_equal(stored["heave"], fresh["heave"])
