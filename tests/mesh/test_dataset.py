"""The mesh as a record: UGRID, whole round trip, quality, figures from it alone."""

import time
from pathlib import Path

import numpy as np
import pytest
from matplotlib.figure import Figure

from squat import records
from squat.errors import InputError
from squat.figures.write import FIGURES
from squat.fluid.run import run as added_mass
from squat.mesh.run import make, run
from squat.mesh.ugrid import from_dataset
from squat.records.mesh_kinds import MESH
from squat.stability.sampling import Ship
from tests.hulls import NAMES

DRAWN = [name for name, (kind, _) in FIGURES.items() if kind is MESH]


@pytest.fixture
def stored(case, tmp_path):
    def make_one(*overrides):
        path = Path(tmp_path) / "mesh.nc"
        dataset = run(case("mesh", "mesh=coarse", *overrides))
        records.save(dataset, path, {"task": "mesh"}, time.perf_counter())
        return records.read(path, MESH)

    return make_one


@pytest.mark.parametrize("hull", ["rectangle", "polygon", "lewis"])
def test_mesh_comes_back_whole_and_moves_as_before(stored, case, hull):
    back = from_dataset(stored(f"hull={hull}"))
    mesh = make(case("mesh", "mesh=coarse", f"hull={hull}"))
    assert back.points.tobytes() == mesh.points.tobytes()
    assert np.array_equal(back.triangles, mesh.triangles)
    assert all(np.array_equal(back.boundary[name], mesh.boundary[name]) for name in mesh.boundary)
    q = np.array([1.0, -3.0, 0.03])
    assert np.array_equal(back.moved(q), mesh.moved(q))
    assert back.order == mesh.order


def test_needles_are_warned_of_by_number_and_ready_made_hulls_have_none(case, caplog):
    for name in NAMES:
        run(case("mesh", "mesh=coarse", f"hull={name}"))
    assert not caplog.records
    close = "hull.points=[[0,0],[0,-9.99],[0.003,-10],[40,-10],[40,0]]"
    found = run(case("mesh", "mesh=coarse", "hull=polygon", close))["face_quality"]
    (line,) = (record.getMessage() for record in caplog.records)
    assert f"{int((found < 0.01).sum())} of {found.size} triangles below 0.01: needles" in line
    assert "hull.points=" in line
    caplog.clear()
    added_mass(case("added_mass", "mesh=coarse", "accuracy.near=0.4", "hull=polygon", close))
    assert [record.getMessage() for record in caplog.records] == [line]
    caplog.clear()
    one = case("limits", "hull=polygon", close)
    ship = Ship(one.hull, one.channel, one.water, "rigid_lid", 0.05, "hulls.mine")
    ship.on(case("mesh", "mesh=coarse").mesh)
    (named,) = (record.getMessage() for record in caplog.records)
    assert named.startswith("mesh of hulls.mine: least quality")
    caplog.clear()
    ship.levels(case("limits", "accuracy.near=0.4").accuracy)
    (named,) = (record.getMessage() for record in caplog.records)
    assert named.startswith("mesh of hulls.mine: least quality")


def test_topology_follows_ugrid(stored):
    data = stored("mesh.order=2")
    topology = data["topology"].attrs
    assert topology["cf_role"] == "mesh_topology"
    assert topology["topology_dimension"] == 2
    for name in topology["node_coordinates"].split():
        assert data[name].dims == ("node",)
    for role in ("face_node_connectivity", "boundary_node_connectivity"):
        connectivity = data[topology[role]]
        assert connectivity.attrs["start_index"] == 0
        assert 0 <= int(connectivity.min()) <= int(connectivity.max()) < data.sizes["node"]
    assert int(data["order"]) == 2


def test_quality_is_recorded_at_rest_and_moved(stored):
    data = stored()
    assert 0 < float(data["face_quality"].min()) <= float(data["face_quality"].max()) <= 1
    assert 0 < float(data["moved_quality"].min()) < float(data["face_quality"].mean())


@pytest.mark.parametrize("name", DRAWN)
def test_figure_is_drawn_from_the_record_alone(stored, name):
    assert isinstance(FIGURES[name][1](stored("hull=v")), Figure)


def test_shown_position_follows_the_clearance_unless_it_is_given(case):
    found = run(case("mesh", "mesh=coarse", "channel.depth=12.0"))
    assert float(found["moved_heave"]) == pytest.approx(-1.0)
    assert float(found["moved_pitch"]) == pytest.approx(0.01)
    given = run(case("mesh", "mesh=coarse", "position.heave=-2.0"))
    assert (float(given["moved_heave"]), float(given["moved_pitch"])) == (-2, 0)


def test_shown_position_out_of_range_is_refused_by_name(case):
    with pytest.raises(
        InputError, match=r"^position\.heave=-12 position\.pitch=0: grounded, clearance -"
    ):
        run(case("mesh", "position.heave=-12.0"))
    with pytest.raises(InputError, match=r"^position\.pitch=0\.4: must be within 0\.26"):
        run(case("mesh", "position.pitch=0.4"))
    slope = "channel.bottom=[[0,0],[1,6]]", "position.surge=3.0", "position.heave=0.0"
    with pytest.raises(
        InputError, match=r"^position\.surge=3 position\.heave=0 position\.pitch=0: folds"
    ):
        run(case("mesh", *slope, "position.pitch=0.0"))
