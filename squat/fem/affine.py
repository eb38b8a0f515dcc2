"""Stiffness in affine form: K(q) = sum_j theta_j(q) K_j with constant K_j, exact in q.

Each zone z (coarse triangle) maps affinely, x = F_z X + const, so that with G = det(F) (F^T F)^-1

    K(q) = sum_z sum_(a<=b) G_ab(z, q) int_z (d_a N_i d_b N_j + d_b N_i d_a N_j) / (1 + delta_ab)

and dK/dq_k follows from dG/dq_k. Assembly is one sparse matrix times the vector of all G_ab.
"""

from dataclasses import dataclass
from functools import cached_property
from itertools import combinations_with_replacement
from typing import Any

import numpy as np
import skfem
from scipy import sparse

from squat.fem.space import Space
from squat.mesh import Mesh, Submesh
from squat.mesh.motion import Index
from squat.quantities import Vector


@dataclass(frozen=True, eq=False)
class ZoneMetrics:
    """G_z(q) = det(F) (F^T F)^-1 of the coarse triangles, and dG_z/dq_k; no fine mesh needed."""

    submesh: Submesh

    def at(self, q: Vector) -> Vector:
        """G, shape (nz, d, d); raises PositionError where `q` is inadmissible."""
        return metric(self._gradient(self.submesh.positions(q)))

    def derivatives(self, q: Vector) -> Vector:
        """dG/dq_k, shape (modes, nz, d, d)."""
        F = self._gradient(self.submesh.positions(q))
        rates = self.submesh.first(q)
        return np.stack([metric_derivative(F, self._gradient(rate)) for rate in rates])

    def _gradient(self, vertices: Vector) -> Vector:
        """F (nz, d, d) of the map that takes the coarse vertices at rest to `vertices`."""
        return _edges(vertices[self.submesh.triangles]) @ self._inverse

    @cached_property
    def _inverse(self) -> Vector:
        submesh = self.submesh
        return np.asarray(np.linalg.inv(_edges(submesh.rest[submesh.triangles])), float)


@dataclass(frozen=True, eq=False)
class AffineStiffness:
    """K(q) and dK/dq_k on a mesh that moves by its submesh, in one sparsity pattern."""

    mesh: Mesh
    space: Space

    @staticmethod
    def on(mesh: Mesh, order: int | None = None) -> "AffineStiffness":
        """For `mesh`, with elements of its order unless another is given."""
        return AffineStiffness(mesh, Space.on(mesh, order))

    @cached_property
    def _parts(self) -> tuple[sparse.csc_array, sparse.csr_array]:
        """The pattern (csc), and the matrix (nnz, entries nz) from theta to its data."""
        basis, zone = self.space.basis, self.mesh.zone
        dofs = basis.element_dofs.T
        n = dofs.shape[1]
        rows = np.repeat(dofs, n, axis=1).ravel()
        columns = np.tile(dofs, (1, n)).ravel()
        key, place = np.unique(columns.astype(np.int64) * basis.N + rows, return_inverse=True)
        pattern = sparse.csc_array(
            (np.zeros(len(key)), key % basis.N, _starts(key // basis.N, basis.N)),
            shape=(basis.N, basis.N),
        )
        values, target = [], []
        entries = metric_entries(basis.mesh.dim())
        for j, (a, b) in enumerate(entries):
            values.append(_local(basis, a, b).ravel())
            target.append(np.repeat(zone * len(entries) + j, n * n))
        shape = len(key), len(entries) * len(self.mesh.submesh.triangles)
        where = np.tile(place.ravel(), len(entries)), np.concatenate(target)
        return pattern, sparse.csr_array((np.concatenate(values), where), shape=shape)

    @property
    def terms(self) -> int:
        """Number of terms of the affine form."""
        return int(self._parts[1].shape[1])

    @cached_property
    def zones(self) -> "ZoneMetrics":
        """The coefficients, from the coarse triangles alone."""
        return ZoneMetrics(self.mesh.submesh)

    def theta(self, q: Vector) -> Vector:
        """Coefficients theta_j(q), shape (terms,)."""
        return flat(self.zones.at(q))

    def theta_derivative(self, q: Vector) -> Vector:
        """d theta_j/dq_k, shape (modes, terms)."""
        return flat(self.zones.derivatives(q))

    def matrix(self, theta: Vector) -> sparse.csc_array:
        """sum_j theta_j K_j for any coefficients (terms,); a new matrix, in the shared pattern."""
        pattern, assemble = self._parts
        data = (assemble @ theta, pattern.indices, pattern.indptr)
        return sparse.csc_array(data, shape=pattern.shape)

    def block(self, rows: Index) -> tuple[sparse.csc_array, sparse.csr_array]:
        """Pattern of the block of `rows` and columns, and the matrix from theta to its data."""
        pattern, assemble = self._parts
        numbered = sparse.csc_array(
            (np.arange(1, pattern.nnz + 1), pattern.indices, pattern.indptr), shape=pattern.shape
        )
        inner = sparse.csc_array(numbered[rows][:, rows])
        return inner.astype(float), sparse.csr_array(assemble[inner.data - 1])

    def term(self, j: int) -> sparse.csc_array:
        """The constant matrix K_j."""
        return self.matrix(np.eye(1, self.terms, j)[0])

    def project(self, V: Vector) -> Vector:
        """V K_j V^T of every term for functions V (N, size), shape (terms, N, N).

        From gradients: K_j V would round off at the size of V, not of its gradient.
        """
        basis, zones = self.space.basis, len(self.mesh.submesh.triangles)
        gradient = np.stack([basis.interpolate(v).grad for v in V])  # (N, d, cells, points)
        scaled = gradient * np.sqrt(basis.dx)
        out = []
        for z in range(zones):
            inside = scaled[:, :, self.mesh.zone == z].reshape(len(V), scaled.shape[1], -1)
            for a, b in metric_entries(basis.mesh.dim()):
                product = inside[:, a] @ inside[:, b].T
                out.append(product if a == b else product + product.T)
        return np.array(out)

    def at(self, q: Vector) -> sparse.csc_array:
        """K(q); raises PositionError where `q` is inadmissible."""
        return self.matrix(self.theta(q))

    def derivatives(self, q: Vector) -> list[sparse.csc_array]:
        """dK/dq_k for each mode, exact."""
        return [self.matrix(rates) for rates in self.theta_derivative(q)]


def metric_entries(dim: int) -> list[tuple[int, int]]:
    """Entries of a symmetric matrix that make it: (0, 0), (0, 1), (1, 1) in two dimensions."""
    return list(combinations_with_replacement(range(dim), 2))


def flat(G: Vector) -> Vector:
    """The entries of metrics (..., nz, d, d) in the order of theta, shape (..., terms)."""
    entries = metric_entries(G.shape[-1])
    rows = np.stack([G[..., a, b] for a, b in entries], axis=-1)
    return rows.reshape(*G.shape[:-3], -1)


def metric(F: Vector) -> Vector:
    """G = det(F) (F^T F)^-1, shape (nz, d, d)."""
    inverse = np.linalg.inv(F)
    return np.asarray(np.linalg.det(F)[:, None, None] * inverse @ inverse.swapaxes(1, 2))


def metric_derivative(F: Vector, dF: Vector) -> Vector:
    """dG = tr(A) G - A G - G A^T with A = F^-1 dF, shape (nz, d, d)."""
    A, G = np.linalg.solve(F, dF), metric(F)
    turned = A @ G
    trace = np.trace(A, axis1=1, axis2=2)[:, None, None]
    return np.asarray(trace * G - turned - turned.swapaxes(1, 2))


def _local(basis: Any, a: int, b: int) -> Vector:
    """Element matrices (m, n, n) of one metric entry."""

    @skfem.BilinearForm  # type: ignore[untyped-decorator]
    def form(u: Any, v: Any, _: Any) -> Any:
        product = u.grad[a] * v.grad[b]
        return product if a == b else product + u.grad[b] * v.grad[a]

    return np.asarray(form.coo_data(basis).tolocal())


def _edges(corners: Vector) -> Vector:
    """Edge vectors as columns, (nz, d, d), from corners (nz, d + 1, d)."""
    return (corners[:, 1:] - corners[:, :1]).swapaxes(1, 2)


def _starts(columns: Index, n: int) -> Index:
    return np.concatenate([[0], np.cumsum(np.bincount(columns, minlength=n))])
