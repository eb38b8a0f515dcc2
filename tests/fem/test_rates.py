"""Orders of convergence: a base class with the expected slope, one small subclass a claim."""

from functools import cache

import numpy as np
import pytest
import skfem

from squat.fem import AffineStiffness, Factorised, HullLoads, Space, flux
from squat.mesh import MeshSize, subdivided
from squat.mesh.generate import generate
from tests.hulls import zones


class Rate:
    """Errors over mesh sizes h; the last observed slope must be `slope` within `tolerance`."""

    order = 1
    slope = 0.0
    tolerance = 0.1

    def sizes_and_errors(self):
        raise NotImplementedError

    def test_rate(self):
        h, errors = map(np.asarray, self.sizes_and_errors())
        slopes = np.diff(np.log(errors)) / np.diff(np.log(h))
        assert slopes[-1] == pytest.approx(self.slope, abs=self.tolerance), slopes


class Manufactured(Rate):
    """-laplacian(u) = 2 pi^2 u, u = sin(pi x) sin(pi y) on the unit square, u = 0 around it."""

    norm = "L2"

    def sizes_and_errors(self):
        counts = (8, 16, 32)
        return [1 / n for n in counts], [self.error(n) for n in counts]

    def error(self, n):
        grid = skfem.MeshTri.init_tensor(*(np.linspace(0, 1, n + 1),) * 2)
        space = Space(
            grid.p.T, grid.t.T, {"all": grid.facets[:, grid.boundary_facets()].T}, self.order
        )
        basis = space.basis.with_element(space.basis.elem)
        rule = skfem.Basis(basis.mesh, basis.elem, intorder=8)
        x, y = rule.global_coordinates()
        u = np.sin(np.pi * x) * np.sin(np.pi * y)
        load = skfem.LinearForm(lambda v, w: 2 * np.pi**2 * w["u"] * v).assemble(rule, u=u)
        found = Factorised.of(space.stiffness(), space.dofs("all")).solve(load).values
        field = rule.interpolate(found)
        exact = [
            np.pi * np.cos(np.pi * x) * np.sin(np.pi * y),
            np.pi * np.sin(np.pi * x) * np.cos(np.pi * y),
        ]
        if self.norm == "L2":
            return np.sqrt(((np.asarray(field) - u) ** 2 * rule.dx).sum())
        return np.sqrt(sum(((field.grad[i] - exact[i]) ** 2 * rule.dx).sum() for i in (0, 1)))


class TestManufacturedP1InL2(Manufactured):
    slope = 2.0


class TestManufacturedP1InH1(Manufactured):
    slope = 1.0
    norm = "H1"


class TestManufacturedP2InL2(Manufactured):
    order = 2
    slope = 3.0


class TestManufacturedP2InH1(Manufactured):
    order = 2
    slope = 2.0
    norm = "H1"


def heave_energy(mesh, order):
    """r . phi = phi^T K phi for unit heave velocity under the lid, section 3.6 at w = 0."""
    affine = AffineStiffness.on(mesh, order)
    load = HullLoads(mesh, affine.space).at(np.zeros(3))[1]
    phi = Factorised.of(affine.at(np.zeros(3)), affine.space.dofs("In")).solve(load).values
    return float(load @ phi)


@cache
def exact_energy():
    """P2 on a finer, more steeply graded mesh; 1e-8 of it is the change to the next finer one."""
    size = MeshSize(near=0.4, far=0.8, slope=0.1, grading=0.8, corner_radius=8.0, order=2)
    return heave_energy(generate(zones("rectangle"), size), 2)


class Corner(Rate):
    """Energy of heave on a hull whose corners have |grad phi|^2 ~ r^(-2/3)."""

    def sizes_and_errors(self):
        pairs = [self.size_and_energy(i) for i in range(3)]
        return [h for h, _ in pairs], [exact_energy() - energy for _, energy in pairs]


class TestCornerEnergyP1Uniform(Corner):
    slope = 4 / 3
    tolerance = 0.12

    def size_and_energy(self, i):
        n = (16, 32, 64)[i]
        return 1 / n, heave_energy(subdivided(zones("rectangle"), n), 1)


class TestCornerEnergyP2Uniform(TestCornerEnergyP1Uniform):
    order = 2

    def size_and_energy(self, i):
        n = (8, 16, 32)[i]
        return 1 / n, heave_energy(subdivided(zones("rectangle"), n), 2)


class TestCornerEnergyP1Graded(Corner):
    """Error over nodes^(-1/2), which is h for graded meshes: optimal order 2."""

    slope = 2.0
    tolerance = 0.2
    grading = 0.5
    sizes = (1.0, 0.5, 0.25)

    def size_and_energy(self, i):
        near = self.sizes[i]
        size = MeshSize(
            near=near, far=2 * near, slope=0.1, grading=self.grading, corner_radius=8.0, order=1
        )
        mesh = generate(zones("rectangle"), size)
        return len(mesh.points) ** -0.5, heave_energy(mesh, self.order)


class TestCornerEnergyP2Graded(TestCornerEnergyP1Graded):
    """Optimal order 4; the corner's own share falls like near^(4/3 / (1 - g)), a little faster."""

    order = 2
    slope = 4.0
    tolerance = 0.6
    grading = 0.7
    sizes = (1.4, 1.0, 0.7)


def test_current_and_heave_reach_the_same_rate_of_work_from_both_sides():
    """b = r_0 . phi_heave = r_heave . phi_0: the mixed energy is symmetric."""
    affine = AffineStiffness.on(subdivided(zones("rectangle"), 8))
    load = np.stack(
        [flux(affine.space, "Out"), HullLoads(affine.mesh, affine.space).at(np.zeros(3))[1]]
    )
    phi = Factorised.of(affine.at(np.zeros(3)), affine.space.dofs("In")).solve(load).values
    assert load[0] @ phi[1] == pytest.approx(load[1] @ phi[0], rel=1e-11)
