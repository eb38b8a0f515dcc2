"""Fine mesh by gmsh, the one place that knows it: coarse edges in, fine triangles out."""

from collections.abc import Iterator
from contextlib import contextmanager

import gmsh
import numpy as np

from squat.errors import InputError
from squat.mesh.count import check_count, corners
from squat.mesh.mesh import Mesh, boundary_edges
from squat.mesh.motion import Index
from squat.mesh.size import MeshSize
from squat.mesh.submesh import Submesh
from squat.quantities import Vector

_OPTIONS = {
    "General.Terminal": 0,
    "General.NumThreads": 1,
    "Mesh.MeshSizeExtendFromBoundary": 0,
    "Mesh.MeshSizeFromPoints": 0,
    "Mesh.MeshSizeFromCurvature": 0,
    "Mesh.Algorithm": 6,  # frontal Delaunay
}


def generate(submesh: Submesh, size: MeshSize) -> Mesh:
    """Mesh whose every triangle lies in one triangle of `submesh`; equal bytes from run to run.

    Raises
    ------
    InputError
        Where it would have more nodes than `size` allows, or gmsh fails, with its reason.
    """
    check_count(submesh, size)
    points, triangles, zone = triangulated(submesh, size)
    named = boundary_edges(submesh, points, triangles, zone)
    return Mesh(submesh, points, triangles, zone, named, size.order)


def triangulated(submesh: Submesh, size: MeshSize) -> tuple[Vector, Index, Index]:
    """Points (n, 2) [m], triangles (m, 3) and the zone of each (m,): what gmsh is asked for."""
    with _session():
        try:
            lines, surfaces = _geometry(submesh)
            _sizes(submesh, size, lines)
            gmsh.model.mesh.generate(2)
            return _result(surfaces)
        except Exception as error:  # gmsh raises nothing more precise
            reason = " ".join(str(error).split())
            raise InputError(
                f"mesh.near={size.near:g}: gmsh failed ({reason}); change it"
            ) from error


@contextmanager
def _session() -> Iterator[None]:
    gmsh.initialize(interruptible=False)
    try:
        for name, value in _OPTIONS.items():
            gmsh.option.setNumber(name, value)
        yield
    finally:
        gmsh.finalize()


def _geometry(submesh: Submesh) -> tuple[dict[tuple[int, int], int], list[int]]:
    """Points, lines and one surface a coarse triangle; tags of lines by edge and of surfaces."""
    geo = gmsh.model.geo
    points = [geo.addPoint(x, z, 0) for x, z in submesh.rest]
    lines = {(int(a), int(b)): geo.addLine(points[a], points[b]) for a, b in submesh.edges}
    surfaces = []
    for triangle in submesh.triangles.tolist():
        sides = zip(triangle, triangle[1:] + triangle[:1], strict=True)
        loop = [lines[a, b] if a < b else -lines[b, a] for a, b in sides]
        surfaces.append(geo.addPlaneSurface([geo.addCurveLoop(loop)]))
    geo.synchronize()
    return lines, surfaces


def _sizes(submesh: Submesh, size: MeshSize, lines: dict[tuple[int, int], int]) -> None:
    """Background field of `MeshSize`."""
    field = gmsh.model.mesh.field
    ship = submesh.boundary["Ship"]
    longest = np.linalg.norm(np.diff(submesh.rest[ship], axis=1), axis=2).max()
    hull = field.add("Distance")
    field.setNumbers(hull, "CurvesList", [lines[min(e), max(e)] for e in ship.tolist()])
    field.setNumber(hull, "Sampling", int(np.clip(2 * longest / size.near, 20, 4000)))
    total = field.add("MathEval")
    field.setString(total, "F", f"{size.near!r}+{size.slope!r}*F{hull}")
    bounds = [total, _constant(size.far)]
    if size.grading and len(found := corners(submesh)):
        bounds.append(_graded(size, [vertex + 1 for vertex in found]))
    least = field.add("Min")
    field.setNumbers(least, "FieldsList", bounds)
    field.setAsBackgroundMesh(least)


def _constant(value: float) -> int:
    tag = int(gmsh.model.mesh.field.add("MathEval"))
    gmsh.model.mesh.field.setString(tag, "F", repr(value))
    return tag


def _graded(size: MeshSize, tags: list[int]) -> int:
    """Field near (max(r, r0) / corner_radius)^g, the maximum smoothed."""
    field = gmsh.model.mesh.field
    distance, graded = field.add("Distance"), int(field.add("MathEval"))
    field.setNumbers(distance, "PointsList", tags)
    r = f"F{distance}"
    scaled = f"({r}*{r}+{size.smallest!r}^2)/{size.corner_radius!r}^2"
    field.setString(graded, "F", f"{size.near!r}*({scaled})^{size.grading / 2!r}")
    return graded


def _result(surfaces: list[int]) -> tuple[Vector, Index, Index]:
    """Nodes, triangles and zones in gmsh's order."""
    tags, coordinates, _ = gmsh.model.mesh.getNodes()
    order = np.argsort(tags)
    place = np.zeros(int(tags.max()) + 1, dtype=np.int64)
    place[tags[order]] = np.arange(len(tags))
    points = coordinates.reshape(-1, 3)[order, :2]
    parts = []
    for surface in surfaces:
        _, _, (nodes,) = gmsh.model.mesh.getElements(2, surface)
        parts.append(place[nodes].reshape(-1, 3))
    zone = np.repeat(np.arange(len(surfaces)), [len(part) for part in parts])
    triangles = np.concatenate(parts)
    a, b, c = (points[i] for i in triangles.T)
    turned = (b - a)[:, 0] * (c - a)[:, 1] < (b - a)[:, 1] * (c - a)[:, 0]
    triangles[turned] = triangles[turned][:, [0, 2, 1]]
    return points, triangles, zone
