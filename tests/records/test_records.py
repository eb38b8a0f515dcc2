"""Datasets: self-describing, written whole or not at all, refused when broken."""

import json

import numpy as np
import pytest
import xarray as xr

from squat import records
from squat.errors import InputError
from squat.piston import run
from squat.records import KINDS, build, is_answer, read, save
from squat.records.piston_kinds import PISTON
from squat.records.provenance import digest
from squat.records.stability_kinds import EQUILIBRIA


@pytest.fixture
def dataset(case):
    return run(case("piston", "time.periods=0.1"))


@pytest.fixture
def path(dataset, tmp_path):
    path = tmp_path / "piston.nc"
    save(dataset, path, {"task": "piston"}, 0.0)
    return path


def test_what_is_written_is_read_back(dataset, path):
    back = read(path, PISTON)
    assert digest(back) == digest(dataset)
    assert json.loads(back.attrs["config"]) == {"task": "piston"}


def test_cf_and_provenance_attributes(path):
    back = read(path)
    for name in ("Conventions", "history", "source", "references", "versions", "git_revision"):
        assert back.attrs[name]
    assert back.attrs["Conventions"].startswith("CF-")
    assert "113280" in back.attrs["references"]
    for variable in back.variables.values():
        assert variable.attrs["units"]
        assert variable.attrs["long_name"]


@pytest.mark.parametrize("strange", [np.nan, np.inf, -np.inf])
def test_a_number_that_is_not_explained_is_not_written(dataset, strange):
    data = {name: variable.values for name, variable in dataset.variables.items()}
    data["contraction"] = np.full_like(data["contraction"], np.nan)
    build(PISTON, data, {"status": "completed"})  # its long name says what NaN means, there
    data["velocity"][3] = strange
    with pytest.raises(InputError, match=f"piston: velocity={strange} is no result"):
        build(PISTON, data, {"status": "completed"})


def test_every_kind_gives_units_and_long_names():
    for kind in KINDS.values():
        for name, variable in kind.variables.items():
            assert variable.units, name
            assert variable.long_name, name


def test_wrong_kind_is_named(path):
    with pytest.raises(InputError, match=r"holds 'piston' in place of 'equilibria'"):
        read(path, EQUILIBRIA)


def test_missing_file_is_named(tmp_path):
    with pytest.raises(InputError, match="is a folder; give a dataset in it"):
        read(tmp_path)
    with pytest.raises(InputError, match=r"absent\.nc: no such file"):
        read(tmp_path / "absent.nc")


@pytest.mark.parametrize("keep", [0, 10, 1000, 0.5, 0.99])
def test_truncated_file_is_refused(path, keep):
    whole = path.read_bytes()
    path.write_bytes(whole[: keep if isinstance(keep, int) else int(keep * len(whole))])
    with pytest.raises(InputError, match=r"piston\.nc: "):
        read(path)


def test_foreign_netcdf_is_refused(tmp_path):
    path = tmp_path / "foreign.nc"
    xr.Dataset({"a": ("x", np.arange(3.0))}).to_netcdf(path, engine="h5netcdf")
    with pytest.raises(InputError, match=r"foreign\.nc: schema '' is not one of squat's"):
        read(path)


def test_future_schema_is_refused(dataset, tmp_path):
    path = tmp_path / "future.nc"
    save(dataset.assign_attrs(schema="squat/piston/99"), path, {}, 0.0)
    with pytest.raises(InputError, match=r"squat/piston/99.*update squat"):
        read(path)


def test_altered_values_are_noticed(dataset, tmp_path):
    path = tmp_path / "altered.nc"
    save(dataset, path, {}, 0.0)
    with xr.open_dataset(path, engine="h5netcdf") as file:
        altered = file.load()
    altered["position"].values[1] += 1e-12
    altered.to_netcdf(path, engine="h5netcdf")
    with pytest.raises(InputError, match="altered since it was written"):
        read(path)


def test_wrong_unit_and_missing_variable_are_named(dataset, tmp_path):
    path = tmp_path / "wrong.nc"
    dataset["position"].attrs["units"] = "ft"
    save(dataset, path, {}, 0.0)
    with pytest.raises(InputError, match=r"'position' is in 'ft' in place of 'm'"):
        read(path)
    save(dataset.drop_vars("position"), path, {}, 0.0)
    with pytest.raises(InputError, match=r"variable 'position' is missing"):
        read(path)


def test_failed_write_leaves_the_old_file_and_no_other(path, tmp_path):
    before = path.read_bytes()
    with pytest.raises(InputError, match="cannot be written"), records.atomic(path) as temporary:
        temporary.write_bytes(b"half")
        raise OSError(28, "No space left on device")
    assert path.read_bytes() == before
    assert [file.name for file in tmp_path.iterdir()] == ["piston.nc"]


def test_build_refuses_what_the_kind_does_not_allow():
    with pytest.raises(InputError, match="is missing"):
        build(PISTON, {"time": [0.0]}, {"status": "converged"})


def test_same_run_gives_the_same_physics(case):
    assert digest(run(case("piston"))) == digest(run(case("piston")))


def test_a_dataset_answers_only_the_configuration_inputs_and_version_that_made_it(
    dataset, path, tmp_path
):
    config = {"task": "piston", "value": 1.0, "out": "a.nc", "inputs": {"mesh": str(path)}}
    made = tmp_path / "made.nc"
    save(dataset, made, config, 0.0)
    assert is_answer(read(made), {**config, "out": "b.nc", "log_level": "debug", "redo": True})
    assert not is_answer(read(made), {**config, "value": 1.5})
    save(dataset, path, {"task": "piston"}, 5.0)  # the same values, written again
    assert is_answer(read(made), config)
    save(dataset.isel(time=slice(3)), path, {"task": "piston"}, 0.0)
    assert not is_answer(read(made), config)
    older = read(made).assign_attrs(versions=json.dumps({"squat": "0.0.1"}))
    assert not is_answer(older, {**config, "inputs": {}})
