"""The expected number of nodes is that of the mesh, to a factor; too many are refused at once."""

import pytest

from squat.errors import InputError
from squat.mesh import submesh
from squat.mesh.count import expected_nodes
from squat.mesh.generate import generate


@pytest.mark.parametrize(
    "overrides",
    [
        ("mesh=coarse",),
        ("mesh=coarse", "hull=lewis"),
        ("mesh=coarse", "mesh.far=1.5", "channel.upstream=400"),
        ("mesh=coarse", "mesh.slope=5"),
        ("mesh=graded", "mesh.grading=0.7"),
    ],
)
def test_expected_nodes_are_those_of_the_mesh_to_a_factor_of_three(case, overrides):
    given = case("mesh", *overrides)
    coarse = submesh(given.hull, given.channel)
    nodes = len(generate(coarse, given.mesh).points)
    assert nodes / 3 < expected_nodes(coarse, given.mesh) < 3 * nodes


@pytest.mark.parametrize("change", ["mesh.near=1e-4", "mesh.near=5e-324", "mesh.max_nodes=300"])
def test_a_mesh_of_too_many_nodes_is_refused_before_it_is_made(case, change):
    given = case("mesh", "mesh=coarse", change)
    with pytest.raises(InputError, match=r"mesh\.near=.* nodes, more than mesh\.max_nodes="):
        generate(submesh(given.hull, given.channel), given.mesh)
