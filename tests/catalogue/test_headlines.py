"""Every kind of run says in the catalogue what a reader asks of it."""

import numpy as np
import pytest
from h5netcdf import File

import squat as api
from squat.catalogue import find, units
from squat.catalogue.difference import difference


def _row(folder, task, *keys):
    run = api.run(task, *keys)
    path = folder / f"{len(list(folder.iterdir()))}.nc"
    run.to_netcdf(path, engine="h5netcdf")
    return run, path, find([path]).iloc[0]


def test_limits_are_figures_with_errors_and_units(tmp_path):
    run, path, row = _row(tmp_path, "limits", "accuracy=coarse")
    for name in ("1D", "2D", "dynamic"):
        one, figure = run.sel(limit=name), f"limit_speed_{name.lower()}"
        assert row[f"result.{figure}"] == float(one["limit_speed"])
        assert row[f"result.{figure}_error"] == float(one["limit_error"])
        with File(path, "r") as file:
            assert units(figure, file) == units(f"{figure}_error", file) == "m s-1"


def test_a_transient_tells_its_least_clearance_and_its_pitch_where_it_may_pitch(tmp_path):
    keys = "current=1", "mesh=coarse", "accuracy.near=0.4", "time.periods=0.05"
    heaving = _row(tmp_path, "transient", *keys)
    pitching = "modes=[heave,pitch]", "coupling=consistent_quasi_newton"
    one = _row(tmp_path, "transient", *keys, *pitching, "initial_pitch=0.01")
    other = _row(tmp_path, "transient", *keys, *pitching, "initial_pitch=0.02")
    for run, _, row in (heaving, one, other):
        assert row["result.clearance_min"] == run["clearance"].values.min()
    assert not [name for name in heaving[2].index if name.startswith("result.pitch")]
    assert one[2]["result.pitch_max"] == one[0]["pitch"].values.max()
    assert one[2]["result.pitch_last"] == one[0]["pitch"].values[-1]
    found = difference(one[1], other[1]).set_index("key")
    assert {"result.pitch_max", "result.pitch_min", "result.clearance_min"} <= set(found.index)


@pytest.mark.parametrize(
    ("task", "keys", "figures"),
    [
        ("mesh", ["mesh=coarse"], {"face_angle_min": "face_angle"}),
        (
            "limits_map",
            ["cases/limits@_global_=small", "accuracy=coarse"],
            {"limit_2d_min": "limit_2d"},
        ),
    ],
)
def test_the_least_of_an_array_is_a_figure(tmp_path, task, keys, figures):
    run, _, row = _row(tmp_path, task, *keys)
    for figure, variable in figures.items():
        assert row[f"result.{figure}"] == np.nanmin(run[variable].values)
