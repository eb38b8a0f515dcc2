"""Solves: residual stated, several right-hand sides, singular systems named."""

import numpy as np
import pytest
from scipy import sparse

from squat.errors import InputError
from squat.fem import AffineStiffness, Factorised, HullLoads, SolveError
from squat.mesh import subdivided
from tests.hulls import zones

AFFINE = AffineStiffness.on(subdivided(zones("rectangle"), 4))
K = AFFINE.at(np.zeros(3))


def test_residual_of_several_loads_is_stated_and_small():
    loads = HullLoads(AFFINE.mesh, AFFINE.space).at(np.zeros(3))
    system = Factorised.of(K, AFFINE.space.dofs("In"))
    together = system.solve(loads[1:])
    assert together.residual < 1e-12
    for load, values in zip(loads[1:], together.values, strict=True):
        assert system.solve(load).values == pytest.approx(values, abs=1e-9)


def test_held_values_are_kept_and_a_linear_potential_is_exact():
    space = AFFINE.space
    x = space.dof_points @ np.array([2.0, -1.0])
    fixed = space.dofs("In", "Out", "Botm", "FreeS", "Ship")
    found = Factorised.of(K, fixed).solve(np.zeros(space.size), x)
    assert found.values == pytest.approx(x, rel=1e-12, abs=1e-10)


def test_no_dirichlet_boundary_is_named():
    with pytest.raises(SolveError, match="no boundary holds the potential"):
        Factorised.of(K, AFFINE.space.dofs())


def test_untied_part_is_named():
    two = sparse.csc_array(sparse.block_diag([K, K]))
    with pytest.raises(SolveError, match="not tied"):
        Factorised.of(two, AFFINE.space.dofs("In"))


def test_matrix_that_is_not_finite_is_named():
    bad = K.copy()
    bad.data = bad.data * np.nan
    with pytest.raises(SolveError, match="flat"):
        Factorised.of(bad, AFFINE.space.dofs("In"))


def test_load_that_is_not_finite_is_named():
    with pytest.raises(SolveError, match="not finite"):
        Factorised.of(K, AFFINE.space.dofs("In")).solve(np.full(K.shape[0], np.inf))


def test_ill_conditioned_system_is_named_and_is_bad_input():
    """Two channels, one of them with a stiffness that rounding cannot tell from zero."""
    two = sparse.csc_array(sparse.block_diag([K, 1e-16 * K]))
    held = AFFINE.space.dofs("In")
    with pytest.raises(SolveError, match="ill-conditioned") as caught:
        Factorised.of(two, np.concatenate([held, held + K.shape[0]]))
    assert isinstance(caught.value, InputError)
