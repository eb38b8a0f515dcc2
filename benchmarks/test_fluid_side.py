"""Mesh motion, assembly and solves: ratios of times taken within one run."""

import json
import time
from functools import cache

import numpy as np
import pytest
from pydantic import TypeAdapter
from scipy import sparse
from scipy.sparse.linalg import splu

from squat.channel import AnyHull, Channel
from squat.config import compose
from squat.fem import AffineStiffness, Factorised, HullLoads
from squat.fluid.stiffness import MovingSolver
from squat.mesh import MeshSize, subdivided, submesh
from squat.mesh.generate import generate

Q = np.array([0.0, -2.0, 0.02])


@cache
def coarse():
    config = compose("mesh")
    hull = TypeAdapter(AnyHull).validate_python(config["hull"])
    return submesh(hull, TypeAdapter(Channel).validate_python(config["channel"]))


@cache
def paper():
    size = TypeAdapter(MeshSize).validate_python(compose("mesh")["mesh"])
    affine = AffineStiffness.on(generate(coarse(), size))
    affine.at(Q)  # parts are built once
    return affine


def seconds(function, times=15):
    taken = []
    for _ in range(times):
        start = time.perf_counter()
        function()
        taken.append(time.perf_counter() - start)
    return float(np.median(taken))


def ratio(benchmark, slow, fast, times=15):
    """Time `fast` by pytest-benchmark and keep slow / fast, both taken here and now."""
    found = seconds(slow, times) / seconds(fast, times)
    benchmark.extra_info["ratio"] = round(found, 2)
    benchmark(fast)
    return found


def test_affine_assembly_against_scikit_fem_on_the_moved_mesh(benchmark):
    affine = paper()

    def direct():
        return affine.space.at(affine.mesh.moved(Q)).stiffness()

    assert ratio(benchmark, direct, lambda: affine.at(Q)) > 3


def laplace_motion():
    """Laplace smoothing of the displacement on the same mesh, boundary displacement given."""
    affine = paper()
    K = affine.at(np.zeros(3))
    fixed = affine.space.dofs("In", "Out", "Botm", "FreeS", "Ship")
    shift = affine.mesh.moved(Q) - affine.mesh.points
    return K, fixed, shift


def test_submesh_against_laplace_mesh_motion_factorised_each_time(benchmark):
    K, fixed, shift = laplace_motion()
    none = np.zeros(len(shift))

    def laplace():
        system = Factorised.of(K, fixed)
        return [system.solve(none, component) for component in shift.T]

    assert ratio(benchmark, laplace, lambda: paper().mesh.moved(Q)) > 10


def test_submesh_against_laplace_mesh_motion_with_a_stored_factor(benchmark):
    K, fixed, shift = laplace_motion()
    none, system = np.zeros(len(shift)), Factorised.of(K, fixed)

    def laplace():
        return [system.solve(none, component) for component in shift.T]

    assert ratio(benchmark, laplace, lambda: paper().mesh.moved(Q)) > 1


@pytest.mark.parametrize("order", ["COLAMD", "MMD_ATA", "NATURAL"])
def test_symmetric_minimum_degree_against_other_orderings(benchmark, order):
    free = np.setdiff1d(np.arange(paper().space.size), paper().space.dofs("In"))
    inner = paper().at(Q)[free][:, free].tocsc()
    symmetric = {"diag_pivot_thresh": 0.0, "options": {"SymmetricMode": True}}
    ratio(
        benchmark,
        lambda: splu(inner, permc_spec=order),
        lambda: splu(inner, permc_spec="MMD_AT_PLUS_A", **symmetric),
        5,
    )


def free_block(q):
    free = np.setdiff1d(np.arange(paper().space.size), paper().space.dofs("In"))
    return paper().at(q)[free][:, free].tocsc(), free


def superlu(matrix):
    options = {"SymmetricMode": True}
    return splu(matrix, permc_spec="MMD_AT_PLUS_A", diag_pivot_thresh=0.0, options=options)


@pytest.mark.parametrize("moved", [0.02, 0.5])
def test_a_new_factor_against_conjugate_gradients_on_a_kept_one(benchmark, moved):
    """After the ship moved by `moved` [m]; kept to the solver's own relative residual."""
    solver = MovingSolver(paper(), paper().space.dofs("In"))
    load = HullLoads(paper().mesh, paper().space).at(Q)[1]
    solver.solve(paper().theta(Q), load)
    first, place = solver._factor, np.add(Q, [0, moved, 0])
    theta = paper().theta(place)
    inner, free = free_block(place)

    def kept():
        solver._factor, solver._recent = first, None  # no help of other solutions
        return solver.solve(theta, load)

    assert ratio(benchmark, lambda: superlu(inner).solve(load[free]), kept) > 1 or moved > 0.1


@pytest.mark.parametrize("library", ["qdldl", "cvxopt"])
def test_superlu_against_symmetric_factorisations(benchmark, library):
    """Only where the library is installed; none is a dependency."""
    module = pytest.importorskip(library)
    inner, free = free_block(Q)
    load = HullLoads(paper().mesh, paper().space).at(Q)[1][free]
    if library == "qdldl":
        upper = sparse.csc_matrix(sparse.triu(inner))

        def other():
            return module.Solver(upper, upper=True).solve(load)
    else:
        cholmod = pytest.importorskip("cvxopt.cholmod")
        coo = inner.tocoo()
        matrix = module.spmatrix(coo.data, coo.row.tolist(), coo.col.tolist(), inner.shape)
        symbol = cholmod.symbolic(matrix)

        def other():
            right = module.matrix(load)
            cholmod.numeric(matrix, symbol)
            cholmod.solve(symbol, right)
            return np.array(right).ravel()

    expected = superlu(inner).solve(load)
    assert np.abs(other() - expected).max() < 1e-9 * np.abs(expected).max()
    ratio(benchmark, lambda: superlu(inner).solve(load), other)


def test_cost_up_to_three_hundred_thousand_nodes(benchmark):
    """Time against nodes, with the exponent observed between the two largest."""
    table = []
    for n in (40, 80, 160, 225):
        mesh = subdivided(coarse(), n)
        affine = AffineStiffness.on(mesh)
        K = affine.at(Q)
        fixed = affine.space.dofs("In")
        load = HullLoads(mesh, affine.space).at(Q)[1]
        system = Factorised.of(K, fixed)
        row = {
            "nodes": len(mesh.points),
            "move": seconds(lambda m=mesh: m.moved(Q), 3),
            "assemble": seconds(lambda a=affine: a.at(Q), 3),
            "factorise": seconds(lambda K=K, f=fixed: Factorised.of(K, f), 1),
            "solve": seconds(lambda s=system, b=load: s.solve(b), 1),
        }
        table.append(row)
    a, b = table[-2:]
    growth = np.log(b["nodes"] / a["nodes"])
    keys = ("move", "assemble", "factorise", "solve")
    exponents = {key: round(float(np.log(b[key] / a[key]) / growth), 2) for key in keys}
    benchmark.extra_info.update(table=json.dumps(table), exponents=exponents)
    assert table[-1]["nodes"] > 300_000
    assert exponents["assemble"] < 1.5
    assert exponents["factorise"] < 2
    benchmark.pedantic(lambda: paper().at(Q), rounds=3)
