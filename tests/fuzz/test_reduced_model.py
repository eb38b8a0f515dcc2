"""A reduced model that is not whole, or not one, is refused by name before any run begins."""

import random

import numpy as np
import pytest
import xarray as xr

from squat import records
from squat.cli.tasks import compute
from squat.config import compose, validate
from squat.reduced import run as make
from tests.fuzz.run import one, tree

TRIALS = 5
RUNS = {
    "transient": ("mesh=coarse", "model=reduced", "time.periods=0.1"),
    "stability_map": ("mesh=coarse", "cases/map@_global_=small"),
}
"""Keys of the runs that a whole model serves."""


@pytest.fixture(scope="module")
def model(tmp_path_factory):
    """A whole record of a reduced model, with both of its groups: file, dataset, configuration."""
    config = compose("reduced", "mesh=coarse", "fields=true", "reduced.positions=12")
    dataset, groups = make(validate(config).case)
    path = tmp_path_factory.mktemp("model") / "whole.nc"
    records.save(dataset, path, config, 0.0, groups)
    return path, dataset, config


@pytest.fixture
def refused(tmp_path, monkeypatch):
    """Hold that a run with the model `file` is refused in one line that names it and `reason`."""
    monkeypatch.chdir(tmp_path)

    def hold(task, file, reason=""):
        before = tree()
        code, _, err, raised = one([f"task={task}", *RUNS[task], f"inputs.reduced={file}"])
        assert (code, raised) == (2, "")
        assert err.count("\n") == 1
        assert err.startswith("squat: ")
        assert file in err
        assert reason in err
        assert tree() == before

    return hold


@pytest.mark.parametrize("task", RUNS)
def test_the_whole_model_serves(model, tmp_path, monkeypatch, task):
    monkeypatch.chdir(tmp_path)
    code, _, _, raised = one([f"task={task}", *RUNS[task], f"inputs.reduced={model[0]}"])
    assert (code, raised) == (0, "")
    assert records.read(tmp_path / f"{task}.nc").attrs["schema"].split("/")[1] == task


def flipped(whole, chance):
    damaged = bytearray(whole)
    for _ in range(chance.choice([1, 4, 32])):
        damaged[chance.randrange(len(whole))] ^= 1 << chance.randrange(8)
    return bytes(damaged)


def truncated(whole, chance):
    return whole[: chance.randrange(len(whole))]


def zeroed(whole, chance):
    written = [n for n in range(0, len(whole) - 512, 512) if any(whole[n : n + 512])]
    place = chance.choice(written)
    return whole[:place] + bytes(512) + whole[place + 512 :]


@pytest.mark.parametrize("task", RUNS)
@pytest.mark.parametrize("harm", [flipped, truncated, zeroed])
def test_a_damaged_model_is_refused(model, refused, tmp_path, task, harm):
    whole, chance = model[0].read_bytes(), random.Random(f"{harm.__name__} {task}")
    for n in range(TRIALS):
        (tmp_path / f"{n}.nc").write_bytes(harm(whole, chance))
        refused(task, f"{n}.nc")


@pytest.mark.parametrize("task", RUNS)
def test_a_model_of_a_later_squat_is_refused(model, refused, tmp_path, task):
    _, dataset, config = model
    later = dataset.assign_attrs(schema="squat/reduced/99")
    records.save(later, tmp_path / "future.nc", config, 0.0)
    refused(task, "future.nc", "update squat")


@pytest.mark.parametrize("task", RUNS)
def test_what_is_no_model_is_refused(refused, tmp_path, task):
    xr.Dataset({"a": ("x", np.arange(3.0))}).to_netcdf(tmp_path / "foreign.nc", engine="h5netcdf")
    refused(task, "foreign.nc")
    config = compose("equilibria", "speeds.points=9", "added_mass_ratio=1")
    records.save(compute(validate(config)), tmp_path / "roots.nc", config, 0.0)
    refused(task, "roots.nc", "'equilibria' in place of 'reduced'")
    (tmp_path / "text.nc").write_text("no dataset")
    refused(task, "text.nc")
    refused(task, "absent.nc", "no such file")


@pytest.mark.parametrize("task", RUNS)
def test_a_model_without_its_groups_is_refused(model, refused, tmp_path, task):
    _, dataset, config = model
    records.save(dataset, tmp_path / "bare.nc", config, 0.0)
    refused(task, "bare.nc", "task=reduced")


@pytest.mark.parametrize("task", RUNS)
def test_a_model_of_another_ship_is_refused(model, refused, tmp_path, task):
    _, dataset, config = model
    other = {**config, "hull": {**config["hull"], "length": 41.0}}
    records.save(dataset, tmp_path / "longer.nc", other, 0.0)
    refused(task, "longer.nc", "another hull")
