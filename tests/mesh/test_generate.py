"""The mesher: embedded edges, bytes, counts, sizes, Euler's formula."""

import numpy as np
import pytest
from pydantic import TypeAdapter, ValidationError

from squat.config import compose
from squat.mesh import MeshSize, quality, smallest_angle
from squat.mesh.generate import generate
from tests.hulls import NAMES, hull, zones
from tests.kept import FOLDER


@pytest.fixture(autouse=True)
def fresh(monkeypatch):
    """No mesh of another process, unless a test asks for it."""
    monkeypatch.delenv(FOLDER)


SIZE = {"far": 2.0, "slope": 0.35, "grading": 0.0, "corner_radius": 5.0, "order": 1}


def size(name, *overrides):
    config = compose("mesh", f"mesh={name}", *overrides)["mesh"]
    return TypeAdapter(MeshSize).validate_python(config)


@pytest.mark.parametrize("name", NAMES)
def test_no_triangle_straddles_two_zones_of_any_hull(name):
    mesh = generate(zones(name), MeshSize(near=0.5, **SIZE))
    assert mesh.straddling() == 0
    assert np.abs(mesh.weights @ mesh.submesh.rest - mesh.points).max() < 1e-12
    assert quality(mesh.points, mesh.triangles).min() > 0.02
    assert smallest_angle(mesh.points, mesh.triangles).mean() > 36  # chords fan out


@pytest.mark.parametrize("name", NAMES)
def test_triangles_nodes_and_boundary_obey_euler(name):
    mesh = generate(zones(name), MeshSize(near=0.5, **SIZE))
    edges = sum(len(named) for named in mesh.boundary.values())
    assert len(mesh.triangles) == 2 * len(mesh.points) - 2 - edges


def test_bytes_are_equal_from_run_to_run():
    one, two = (generate(zones("lewis"), MeshSize(near=0.5, **SIZE)) for _ in range(2))
    assert one.points.tobytes() == two.points.tobytes()
    assert one.triangles.tobytes() == two.triangles.tobytes()


def test_the_mesh_that_another_process_keeps_is_the_fresh_one(monkeypatch, tmp_path):
    asked = zones("lewis"), MeshSize(near=0.5, **SIZE)
    fresh = generate(*asked)
    monkeypatch.setenv(FOLDER, str(tmp_path))
    kept_once, kept = generate(*asked), generate(*asked)
    assert len(list(tmp_path.iterdir())) == 1
    for mesh in (kept_once, kept):
        assert mesh.points.tobytes() == fresh.points.tobytes()
        assert mesh.triangles.tobytes() == fresh.triangles.tobytes()
        assert mesh.zone.tobytes() == fresh.zone.tobytes()


def test_paper_mesh_has_the_printed_node_count_within_a_tenth():
    mesh = generate(zones("rectangle"), size("paper"))
    assert len(mesh.points) == pytest.approx(3295, rel=0.1)
    # Its triangles cannot be twice the nodes: Euler's formula subtracts the boundary.
    assert len(mesh.triangles) < 2 * len(mesh.points) - 2


def test_coarse_and_fine_and_graded_are_what_they_say():
    counts = {n: len(generate(zones("rectangle"), size(n)).points) for n in ("coarse", "paper")}
    assert counts["coarse"] < counts["paper"] / 3
    graded = size("graded")
    mesh = generate(zones("rectangle"), graded)
    keel = np.array([0.0, 10.0])
    edges = np.sort(np.linalg.norm(mesh.points - keel, axis=1))
    assert edges[1] == pytest.approx(graded.smallest, rel=0.5)


def test_edges_on_the_hull_are_near_long():
    mesh = generate(zones("rectangle"), size("paper"))
    ship = mesh.points[mesh.boundary["Ship"]]
    lengths = np.linalg.norm(ship[:, 1] - ship[:, 0], axis=1)
    assert lengths.max() <= 0.1 * (1 + 0.05)  # equal parts of each side, rounded


@pytest.mark.parametrize(
    ("changes", "words"),
    [
        ({"near": 3.0}, r"mesh.far=2: must be at least mesh.near=3"),
        ({"near": 1.0, "corner_radius": 0.5, "grading": 0.5}, r"mesh.near=1: must be less than"),
    ],
)
def test_impossible_sizes_are_refused_by_name(changes, words):
    with pytest.raises(ValidationError, match=words):  # pydantic's cover of InputError
        MeshSize(**{"near": 0.5, **SIZE, **changes})


def test_hull_of_the_mesh_is_the_outline():
    mesh = generate(zones("chamfered_box"), MeshSize(near=0.5, **SIZE))
    ship = mesh.points[mesh.boundary["Ship"]]
    perimeter = np.linalg.norm(ship[:, 1] - ship[:, 0], axis=1).sum()
    vertices = hull("chamfered_box").outline.vertices
    assert perimeter == pytest.approx(np.linalg.norm(np.diff(vertices, axis=0), axis=1).sum())
