"""Fine mesh embedded in a submesh; subdivision of the coarse triangles without any mesher."""

from dataclasses import dataclass, replace
from functools import cached_property
from typing import Literal

import numpy as np
from scipy import sparse

from squat.mesh.motion import Index
from squat.mesh.submesh import Submesh
from squat.quantities import Vector

_ON_EDGE = 1e-10


@dataclass(frozen=True, eq=False)
class Mesh:
    """Triangles, each inside one coarse triangle, so that all move affinely.

    Parameters
    ----------
    submesh
        Coarse triangulation and its motion.
    points
        Nodes (n, 2) [m] at q = 0.
    triangles
        (m, 3) nodes, counterclockwise.
    zone
        Coarse triangle of each triangle, shape (m,).
    boundary
        Edges (k, 2) by name: In, Out, Botm, FreeS, Ship; the water on their left.
    order
        Of the elements meant for the triangles.
    """

    submesh: Submesh
    points: Vector
    triangles: Index
    zone: Index
    boundary: dict[str, Index]
    order: Literal[1, 2] = 1

    @cached_property
    def weights(self) -> sparse.csr_array:
        """Barycentric weights (n, nc), stored once: node = weights @ coarse vertices."""
        owner = np.zeros(len(self.points), dtype=np.int64)
        owner[self.triangles.ravel()] = np.repeat(self.zone, 3)
        local = barycentric(self.points, self.submesh.rest[self.submesh.triangles[owner]])
        local[np.abs(local) < _ON_EDGE] = 0  # nodes on an edge follow its two ends alone
        local /= local.sum(axis=1, keepdims=True)
        rows = np.repeat(np.arange(len(self.points)), 3)
        columns = self.submesh.triangles[owner].ravel()
        shape = len(self.points), len(self.submesh.rest)
        matrix = sparse.csr_array((local.ravel(), (rows, columns)), shape=shape)
        matrix.eliminate_zeros()
        return matrix

    def about(self, center: Vector) -> "Mesh":
        """The same, for pitch about another point of the hull, `center` (2,) [m] at rest."""
        return replace(self, submesh=self.submesh.about(center))

    def moved(self, q: Vector) -> Vector:
        """Nodes (n, 2) [m] at `q`; raises PositionError where it is inadmissible."""
        return np.asarray(self.weights @ self.submesh.positions(q))

    def velocities(self, q: Vector) -> Vector:
        """dx/dq_k of the nodes, shape (modes, n, 2): the mesh velocity per unit q_k'."""
        return np.stack([self.weights @ rate for rate in self.submesh.first(q)])

    def straddling(self) -> int:
        """Number of triangles with a corner outside of their coarse triangle."""
        corners = self.points[self.triangles].reshape(-1, 2)
        zones = self.submesh.rest[self.submesh.triangles[np.repeat(self.zone, 3)]]
        outside = barycentric(corners, zones).min(axis=1) < -_ON_EDGE
        return int(outside.reshape(-1, 3).any(axis=1).sum())


def barycentric(points: Vector, corners: Vector) -> Vector:
    """Barycentric coordinates (n, 3) of `points` (n, 2) in triangles `corners` (n, 3, 2)."""
    edges = np.stack([corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]], axis=-1)
    inner = np.linalg.solve(edges, (points - corners[:, 0])[..., None])[..., 0]
    return np.column_stack([1 - inner.sum(axis=1), inner])


def subdivided(submesh: Submesh, n: int, order: Literal[1, 2] = 1) -> Mesh:
    """Structured mesh: every coarse triangle cut into n^2 similar ones, by numpy alone."""
    grid = np.array([(i, j) for j in range(n + 1) for i in range(n + 1 - j)])
    place = {tuple(ij): k for k, ij in enumerate(grid.tolist())}
    up = [[(i, j), (i + 1, j), (i, j + 1)] for i, j in grid if i + j < n]
    down = [[(i + 1, j), (i + 1, j + 1), (i, j + 1)] for i, j in grid if i + j < n - 1]
    local = np.array([[place[int(i), int(j)] for i, j in corners] for corners in up + down])
    shape = np.column_stack([n - grid.sum(axis=1), grid])  # integer weights: shared nodes agree
    nodes, index = _shared(submesh.triangles, shape)
    triangles = index.reshape(len(submesh.triangles), -1)[:, local].reshape(-1, 3)
    weights = np.zeros((len(nodes), len(submesh.rest)))
    for k in range(3):
        weights[np.arange(len(nodes)), nodes[:, 2 * k]] += nodes[:, 2 * k + 1] / n
    zone = np.repeat(np.arange(len(submesh.triangles)), len(local))
    points = weights @ submesh.rest
    return Mesh(
        submesh, points, triangles, zone, boundary_edges(submesh, points, triangles, zone), order
    )


def _shared(triangles: Index, shape: Index) -> tuple[Index, Index]:
    """Each node once, as sorted (vertex, weight) pairs (n, 6), and the index of every copy."""
    pairs = np.empty((len(triangles), len(shape), 3, 2), dtype=np.int64)
    pairs[..., 0] = triangles[:, None, :]
    pairs[..., 1] = shape[None]
    pairs[..., 0] = np.where(pairs[..., 1] == 0, 0, pairs[..., 0])
    order = np.lexsort((pairs[..., 1], pairs[..., 0]), axis=-1)
    ordered = np.take_along_axis(pairs, order[..., None], axis=2).reshape(-1, 6)
    nodes, index = np.unique(ordered, axis=0, return_inverse=True)
    return nodes, index


def boundary_edges(
    submesh: Submesh, points: Vector, triangles: Index, zone: Index
) -> dict[str, Index]:
    """Fine edges on each named boundary: sides of triangles that lie on a coarse boundary edge."""
    corner = barycentric(
        points[triangles].reshape(-1, 2), submesh.rest[submesh.triangles[np.repeat(zone, 3)]]
    ).reshape(-1, 3, 3)
    zero = np.abs(corner) < _ON_EDGE
    place = {(int(a), int(b)): name for name, edges in submesh.boundary.items() for a, b in edges}
    found: dict[str, list[Index]] = {name: [] for name in submesh.boundary}
    for side in range(3):
        for opposite in range(3):
            ends = [(opposite + 1) % 3, (opposite + 2) % 3]
            on = zero[:, side, opposite] & zero[:, (side + 1) % 3, opposite]
            for z in np.unique(zone[on]):
                name = place.get(tuple(submesh.triangles[z, ends].tolist()))
                if name is not None:
                    here = triangles[on & (zone == z)]
                    found[name].append(here[:, [side, (side + 1) % 3]])
    return {name: np.concatenate(edges) for name, edges in found.items()}
