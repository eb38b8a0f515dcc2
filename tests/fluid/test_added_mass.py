"""The added-mass matrix: theorems, anchors, accuracy, projection."""

from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from squat.channel import Channel, HalfEllipse, Rectangle
from squat.config import compose, validate
from squat.fluid.accuracy import accurate, extrapolate
from squat.fluid.added_mass import AddedMass, hull_nodes, nodal_matrix
from squat.fluid.deep_water import heave_inertia_coefficient
from squat.fluid.hull_modes import HullMode, bending
from squat.fluid.inertia import Found, deep_limit
from squat.fluid.matching import RectangleReference, rigid_modes
from squat.fluid.run import run
from squat.mesh import subdivided, submesh

ACCURACY = validate(compose("added_mass")).case.accuracy
CHANNEL = Channel(depth=20.0, upstream=40.0, downstream=60.0)


def rectangle(length=40.0, draft=10.0):
    return Rectangle(shape="rectangle", length=length, draft=draft, pitch_center="waterline")


@pytest.mark.parametrize("free_surface", ["zero_pressure", "rigid_lid"])
def test_matrix_is_symmetric_and_positive_definite(free_surface):
    solved = AddedMass(subdivided(submesh(rectangle(), CHANNEL), 4), free_surface)
    product = solved.loads @ solved.potentials.T
    scale = np.sqrt(np.outer(np.diag(product), np.diag(product)))
    assert np.abs((product - product.T) / scale).max() < 1e-12  # reciprocity, to the solve
    assert np.linalg.eigvalsh(solved.matrix / scale).min() > 0


@pytest.mark.parametrize("free_surface", ["zero_pressure", "rigid_lid"])
def test_nested_refinement_raises_the_matrix_towards_the_exact_one(free_surface):
    """Galerkin energies are lower bounds: differences are positive semidefinite."""
    coarse = submesh(rectangle(), CHANNEL)
    found = [AddedMass(subdivided(coarse, n), free_surface).matrix for n in (2, 4, 8, 16)]
    reference = RectangleReference(40.0, 10.0, 20.0, 40.0, 60.0, free_surface)
    found.append(reference.added_mass(rigid_modes(20.0, 20.0)))
    scale = np.sqrt(np.diag(found[-1]))
    for lower, upper in pairwise(found):
        change = (upper - lower) / np.outer(scale, scale)
        assert np.linalg.eigvalsh((change + change.T) / 2).min() > -1e-9


@settings(max_examples=3, deadline=None)
@given(
    st.floats(1.2, 6.0),
    st.floats(0.5, 5.0),
    st.floats(1.0, 3.0),
    st.sampled_from(["zero_pressure", "rigid_lid"]),
)
def test_extrapolated_values_hold_their_error_on_any_rectangle(ratio, a, distance, free_surface):
    draft = 20 / ratio
    length = 2 * a * draft
    ends = distance * 20.0, distance * 25.0
    channel = Channel(depth=20.0, upstream=ends[0], downstream=ends[1])
    value, error = accurate(rectangle(length, draft), channel, ACCURACY, free_surface)
    reference = RectangleReference(length, draft, 20.0, *ends, free_surface, 60_000, 24)
    exact = reference.added_mass(rigid_modes(length / 2, 20.0))
    # The reference itself has six digits in surge and pitch (their second singularity).
    own = 1e-5 * np.sqrt(np.outer(np.diag(exact), np.diag(exact)))
    own[1, 1] *= 1e-3
    assert (np.abs(value - exact) <= error + own).all()
    assert (np.diag(np.abs(value - exact)) < 1e-3 * np.diag(exact)).all()


def test_half_circle_in_deep_water_is_half_its_displaced_mass():
    """Heave, zero pressure: rho pi a^2/2; a 2n-gon's section converges like 1/n^2."""
    found = []
    for depth in (10.0, 20.0, 40.0):
        hull = HalfEllipse(
            shape="half_ellipse",
            length=2.0,
            draft=1.0,
            pitch_center="waterline",
            segments=64,
            wall=1e-3,
        )
        channel = Channel(depth=depth, upstream=3 * depth, downstream=3 * depth)
        value, error = accurate(hull, channel, ACCURACY, "zero_pressure")
        found.append(Found(value[1, 1] / np.pi, error[1, 1] / np.pi, np.nan, 0))
    assert deep_limit((10.0, 20.0, 40.0), found).value == pytest.approx(0.5, abs=2e-3)


def test_square_in_deep_water_is_schwarz_and_christoffels():
    found = []
    for depth in (10.0, 20.0, 40.0):
        channel = Channel(depth=depth, upstream=3 * depth, downstream=3 * depth)
        value, error = accurate(rectangle(2.0, 1.0), channel, ACCURACY, "zero_pressure")
        found.append(Found(value[1, 1] / np.pi, error[1, 1] / np.pi, np.nan, 0))
    limit = deep_limit((10.0, 20.0, 40.0), found)
    assert abs(limit.value - heave_inertia_coefficient(1.0)) < limit.error < 1e-4


def test_thin_gap_slope():
    """di/d(a/T) -> 2/(3 pi (H/T - 1)) as the gap closes."""
    i = []
    for a in (10.0, 12.0):
        channel = Channel(depth=1.05, upstream=50.0, downstream=50.0)
        loose = replace(ACCURACY, near=0.5)
        value, _ = accurate(rectangle(2 * a, 1.0), channel, loose, "zero_pressure")
        i.append(value[1, 1] / (np.pi * a**2))
    assert (i[1] - i[0]) / 2 == pytest.approx(2 / (3 * np.pi * 0.05), rel=0.01)


def test_modal_matrix_is_the_projection_of_the_nodal_one():
    """[m] = [X]^T [M] [X], Eq. (26), for rigid modes and a bending girder."""
    mesh = subdivided(submesh(rectangle(), CHANNEL), 6)
    girder = bending(1, 0.0, 40.0)
    direct = AddedMass(mesh, "zero_pressure", [girder])
    points = mesh.points[hull_nodes(mesh)]
    centre = np.array([20.0, 20.0])
    arm = points - centre
    fields = [
        np.column_stack([np.ones(len(points)), np.zeros(len(points))]),
        np.column_stack([np.zeros(len(points)), np.ones(len(points))]),
        np.column_stack([-arm[:, 1], arm[:, 0]]),
        girder.field(points),
    ]
    X = np.stack([field.T.ravel() for field in fields], axis=1)
    projected = X.T @ nodal_matrix(mesh, "zero_pressure") @ X
    scale = np.sqrt(np.outer(np.diag(projected), np.diag(projected)))
    assert np.abs((projected - direct.matrix) / scale).max() < 1e-12


def test_a_field_equal_to_heave_has_heaves_row():
    mesh = subdivided(submesh(rectangle(), CHANNEL), 4)
    again = HullMode(
        "lift",
        lambda points: np.stack([np.zeros(points.shape[:-1]), np.ones(points.shape[:-1])], axis=-1),
    )
    matrix = AddedMass(mesh, "zero_pressure", [again]).matrix
    assert matrix[3, 3] == pytest.approx(matrix[1, 1], rel=1e-13)


@pytest.mark.parametrize(("number", "nodes"), [(1, 2), (2, 3), (3, 4)])
def test_bending_modes_are_those_of_a_free_free_girder(number, nodes):
    """Unit at the bow, n + 1 nodes, orthogonal to rigid motion."""
    x = np.linspace(0, 40, 4001)
    shape = bending(number, 0.0, 40.0).field(np.column_stack([x, np.zeros_like(x)]))[:, 1]
    assert shape[0] == pytest.approx(1)
    assert np.count_nonzero(np.diff(np.sign(shape))) == nodes
    weight = np.gradient(x)
    weight[[0, -1]] /= 2
    for rigid in (np.ones_like(x), x - 20):
        assert abs((shape * rigid * weight).sum()) < 1e-4 * (abs(shape * rigid) * weight).sum()


@pytest.mark.parametrize("order", [1.0, 4 / 3, 2.0, 4.0])
def test_extrapolation_recovers_a_power_law(order):
    levels = [np.array([3.0 - 0.1 * h**order]) for h in (4.0, 2.0, 1.0)]
    value, error = extrapolate(levels, 2.0, 1.25)
    assert value == pytest.approx(3.0, abs=1e-12)
    assert error == pytest.approx(1.25 * 0.1, rel=1e-6)


def test_extrapolation_keeps_the_finest_value_where_changes_do_not_shrink():
    value, error = extrapolate([np.array([1.0]), np.array([1.1]), np.array([0.9])], 2.0, 1.25)
    assert value == pytest.approx(0.9)
    assert error == pytest.approx(0.25)


def test_record_has_the_promised_names(case):
    data = run(case("added_mass", "mesh=coarse", "bending_modes=1"))
    assert list(data["mode_i"].values) == ["surge", "heave", "pitch", "bending_1"]
    assert data["added_mass"].dims == ("mode_i", "mode_j")
    assert data["pressure"].dims == ("mode", "node")
    assert data["added_mass"].sel(mode_i="heave", mode_j="surge").entry_units == "kg m-1"
    assert data["added_mass"].sel(mode_i="heave", mode_j="pitch").entry_units == "kg"
    assert data["added_mass_error"].sel(mode_i="pitch", mode_j="pitch").entry_units == "kg m"
    assert list(data["pressure"].pressure_units.values) == ["kg m-2", "kg m-2", "kg m-1", "kg m-2"]
    assert 0 < data.attrs["residual"] < 1e-9
    raw = abs(data["added_mass_mesh"] - data["added_mass"])
    assert bool((raw <= data["added_mass_mesh_error"]).all())
    assert bool((data["added_mass_mesh_error"] >= data["added_mass_error"]).all())
    i = float(data["added_mass"].sel(mode_i="heave", mode_j="heave")) / (1000 * np.pi * 20**2)
    assert float(data["inertia_coefficient"]) == pytest.approx(i)


def test_record_holds_the_water_and_no_pressure_at_its_open_sides(case):
    data = run(case("added_mass", "mesh=coarse"))
    x, z = data["node_x"].values, data["node_z"].values
    a, b, c = (np.stack([x, z])[:, nodes] for nodes in data["face_node"].values.T)
    (ux, uz), (vx, vz) = b - a, c - a
    assert (ux * vz - uz * vx).sum() / 2 == pytest.approx((40 + 40 + 60) * 20 - 40 * 10)
    free = (x == x.min()) | (x == x.max()) | (z == z.max())
    assert free.sum() > 20
    assert np.array_equal(data["pressure"].values.any(axis=0), ~free)


def test_p2_lies_between_p1_on_the_same_triangles_and_the_extrapolated_value(case):
    linear, quadratic = (
        run(case("added_mass", "mesh=coarse", f"mesh.order={order}")) for order in (1, 2)
    )
    assert linear.sizes == quadratic.sizes
    names = ("surge", "heave", "pitch")
    for data in (linear, quadratic):
        assert bool((data["added_mass"] == linear["added_mass"]).all())
    for name in names:
        at = {"mode_i": name, "mode_j": name}
        low, high = (float(d["added_mass_mesh"].sel(at)) for d in (linear, quadratic))
        top = float((linear["added_mass"] + linear["added_mass_error"]).sel(at))
        assert low < high < top


def test_pitch_about_the_centroid_shifts_the_matrix_like_any_rigid_mode(case):
    """V_pitch about c' = V_pitch about c + (c'_z - c_z) V_surge - (c'_x - c_x) V_heave."""
    about = {
        name: run(case("added_mass", "mesh=coarse", f"hull.pitch_center={name}"))
        for name in ("waterline", "centroid")
    }
    water, centroid = (about[n]["added_mass_mesh"].values for n in ("waterline", "centroid"))
    shift = np.eye(3)
    shift[2, 0] = -5.0  # the centroid lies T/2 below the water line
    assert centroid == pytest.approx(shift @ water @ shift.T, rel=1e-9, abs=1e-6 * water.max())


def test_meshes_of_an_estimate_are_scaled_copies(case):
    """Every length but the growth follows the level, near the hull and far away."""
    asked = case("added_mass")
    sizes = [asked.accuracy.size(asked.hull, asked.channel, level) for level in range(3)]
    scale = min(asked.channel.depth - asked.hull.draft, asked.hull.draft, asked.hull.length / 2)
    for level, size in enumerate(sizes):
        factor = asked.accuracy.refinement ** (2 - level)
        assert size.near == pytest.approx(factor * asked.accuracy.near * scale)
        assert size.far == pytest.approx(factor * asked.accuracy.far * asked.channel.depth)
        assert size.slope == asked.accuracy.slope


def test_a_matrix_is_solved_for_once_and_nobody_can_change_it():
    loose = replace(ACCURACY, near=0.64)
    first = accurate(rectangle(), CHANNEL, loose, "zero_pressure")
    again = accurate(rectangle(), CHANNEL, replace(loose), "zero_pressure", [])
    assert again is first
    other = accurate(rectangle(draft=9.0), CHANNEL, loose, "zero_pressure")
    assert (other.value != first.value).any()
    with pytest.raises(ValueError, match="read-only"):
        first.value[0, 0] = 0.0
