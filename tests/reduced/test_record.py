"""A reduced model is a record: written, read, of full use without the mesh that it came from."""

import numpy as np
import pytest

from squat import records
from squat.errors import InputError
from squat.fluid.model import Flow
from squat.records.reduced_kinds import REDUCED
from squat.reduced import bounds, load


@pytest.fixture(scope="module")
def made():
    from squat.config import compose, validate
    from squat.reduced import run

    config = compose("reduced", "mesh=coarse", "reduced.positions=8", "fields=true")
    return config, *run(validate(config).case)


@pytest.fixture(scope="module")
def file(made, tmp_path_factory):
    config, dataset, groups = made
    path = tmp_path_factory.mktemp("reduced") / "model.nc"
    records.save(dataset, path, config, 0.0, groups)
    return path


def test_model_read_back_answers_bit_by_bit(file, pair):
    two = pair("mesh=coarse", "reduced.positions=8")
    model = load(file).model
    for q in two.positions(20):
        assert np.array_equal(model.energies(q), two.model.energies(q))
        mine, theirs = bounds(model, q), bounds(two.model, q)
        assert np.array_equal(mine.slopes.c, theirs.slopes.c)


def test_pressure_force_needs_only_the_triangles_beside_the_hull(file, pair, at):
    near, whole = load(file), load(file, fields=True)
    assert len(near.mesh.points) < len(whole.mesh.points) / 2
    water = pair("mesh=coarse", "reduced.positions=8").case.water
    forces = []
    for loaded in (near, whole):
        fluid = loaded.fluid(water, 1.5)
        flow = fluid.flow(at(-2), at(0.2))
        forces.append(fluid.force(Flow(*flow), 0.1 * flow.potential))
    assert forces[0] == pytest.approx(forces[1], rel=1e-12)


def test_record_carries_its_certificate_and_provenance(file):
    data = records.read(file, REDUCED)
    assert data.attrs["full_solves"] == data.sizes["round"] == 8
    assert np.all(data["round_bound"][-1] < data["round_bound"][0])
    assert records.config_of(data)["mesh"]["near"] > 0
    assert {"git_revision", "versions", "wall_time"} <= set(data.attrs)


def test_default_heave_model_is_under_a_megabyte_without_fields(heave):
    from squat.reduced.record import to_record

    assert to_record(heave.made, len(heave.mesh.points)).nbytes < 1e6


def test_file_without_fields_says_how_to_make_them(made, tmp_path):
    config, dataset, groups = made
    records.save(dataset, tmp_path / "m.nc", config, 0.0, {"hull": groups["hull"]})
    with pytest.raises(InputError, match="fields=true"):
        load(tmp_path / "m.nc", fields=True)


def test_another_kind_is_refused(case, tmp_path):
    from squat.stability.run import run

    records.save(run(case("equilibria", "added_mass_ratio=1")), tmp_path / "e.nc", {}, 0.0)
    with pytest.raises(InputError, match="squat task=reduced"):
        load(tmp_path / "e.nc")
