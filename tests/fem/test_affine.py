"""K(q), its derivatives and the loads, against scikit-fem on the moved mesh and differences."""

from functools import cache

import numpy as np
import pytest

from squat.fem import AffineStiffness, HullLoads, flux
from squat.mesh import PositionError, subdivided, submesh
from tests.hulls import CHANNEL, NAMES, hull, zones

Q = np.array([1.0, -3.0, -0.05])
STEP = 1e-5


@cache
def stiffness(name, order):
    return AffineStiffness.on(subdivided(zones(name), 4, order))


CASES = pytest.mark.parametrize("order", [1, 2])
HULLS = pytest.mark.parametrize("name", NAMES)


@HULLS
@CASES
def test_affine_form_equals_direct_assembly_on_the_moved_mesh(name, order):
    affine = stiffness(name, order)
    direct = affine.space.at(affine.mesh.moved(Q)).stiffness()
    assert abs(affine.at(Q) - direct).max() < 1e-12 * abs(direct).max()


@HULLS
@CASES
def test_derivative_by_each_mode_agrees_with_finite_differences(name, order):
    affine = stiffness(name, order)
    for derivative, e in zip(affine.derivatives(Q), STEP * np.eye(3), strict=True):
        difference = (affine.at(Q + e) - affine.at(Q - e)) / (2 * STEP)
        # rounding, 1e-14 |K| / step, and step^2 times the third derivative
        assert abs(derivative - difference).max() < 1e-7 * abs(affine.at(Q)).max()


@CASES
def test_sum_of_the_terms_is_the_matrix(order):
    affine = stiffness("rectangle", order)
    theta = affine.theta(Q)
    total = sum(theta[j] * affine.term(j) for j in range(affine.terms))
    assert abs(affine.at(Q) - total).max() < 1e-13 * abs(total).max()


def test_stiffness_is_symmetric_and_constants_have_no_energy():
    K = stiffness("lewis", 2).at(Q)
    assert abs(K - K.T).max() < 1e-13 * abs(K).max()
    assert np.abs(K @ np.ones(K.shape[0])).max() < 1e-11 * abs(K).max()


@HULLS
@CASES
def test_derivatives_of_the_loads_agree_with_finite_differences(name, order):
    affine = stiffness(name, order)
    loads = HullLoads(affine.mesh, affine.space)
    derivatives = loads.derivatives(Q)
    for k, e in enumerate(STEP * np.eye(3)):
        difference = (loads.at(Q + e) - loads.at(Q - e)) / (2 * STEP)
        assert np.abs(derivatives[:, k] - difference).max() < 1e-7


@HULLS
@CASES
def test_loads_of_a_unit_potential_are_the_closed_form_fluxes(name, order):
    affine = stiffness(name, order)
    loads = HullLoads(affine.mesh, affine.space).at(np.zeros(3)).sum(axis=1)
    outline = hull(name).outline
    # Divergence theorem on the ship, which n points into: int V.n ds = int over its water plane.
    first_moment = -outline.length * (outline.vertices[[0, -1], 0].mean() - outline.center[0])
    assert loads == pytest.approx([0, outline.length, -first_moment], abs=1e-9)


def test_out_lets_the_channel_depth_through():
    affine = stiffness("rectangle", 2)
    assert flux(affine.space, "Out").sum() == pytest.approx(CHANNEL.depth)


def test_heave_load_of_vertical_sides_is_constant_in_heave():
    box = stiffness("rectangle", 1)
    loads = HullLoads(box.mesh, box.space)
    assert np.abs(loads.derivatives(np.array([0.0, -2.0, 0.0]))[1, 1]).max() < 1e-14


def test_modes_select_what_is_derived():
    heave = AffineStiffness.on(subdivided(submesh(hull("v"), CHANNEL, ("heave",)), 2))
    q = np.array([-2.0])
    assert len(heave.derivatives(q)) == 1
    assert HullLoads(heave.mesh, heave.space).derivatives(q).shape[:2] == (1, 1)
    full = stiffness("v", 1)
    assert full.theta(np.array([0, -2.0, 0])) == pytest.approx(heave.theta(q))


def test_inadmissible_position_has_no_matrix():
    with pytest.raises(PositionError, match="grounded"):
        stiffness("rectangle", 1).at(np.array([0, -9.9, 0]))


@CASES
def test_projected_terms_and_blocks_are_those_of_the_matrix(order):
    affine = stiffness("rectangle", order)
    theta, size = affine.theta(Q), affine.at(Q).shape[0]
    V = np.random.default_rng(1).standard_normal((3, size))
    projected = np.einsum("j,jab->ab", theta, affine.project(V))
    direct = V @ (affine.at(Q) @ V.T)
    assert projected == pytest.approx(direct, rel=1e-11, abs=1e-11 * np.abs(direct).max())
    rows = np.arange(3, size, 2)
    pattern, assemble = affine.block(rows)
    pattern.data = assemble @ theta
    inner = affine.at(Q)[rows][:, rows]
    assert abs(pattern - inner).max() < 1e-12 * abs(inner).max()
