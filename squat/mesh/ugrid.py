"""Meshes as datasets: UGRID 1.0 topology, coarse triangulation and its motion included."""

from dataclasses import astuple

import numpy as np
import xarray as xr

from squat.mesh.limits import Limits
from squat.mesh.mesh import Mesh
from squat.mesh.motion import MODES, Anchors, RigidMotion
from squat.mesh.quality import quality, smallest_angle
from squat.mesh.submesh import BOUNDARIES, Submesh
from squat.quantities import Vector
from squat.records import build
from squat.records.mesh_kinds import MESH

_TOPOLOGY = {
    "cf_role": "mesh_topology",
    "topology_dimension": 2,
    "node_coordinates": "node_x node_z",
    "face_node_connectivity": "face_node",
    "boundary_node_connectivity": "edge_node",
}


def to_dataset(mesh: Mesh, q: Vector) -> xr.Dataset:
    """Dataset of kind `mesh`; `q` (3,): the position that it is shown moved to."""
    moved = mesh.moved(q)
    names = [name for name in BOUNDARIES if len(mesh.boundary[name])]
    edges = [mesh.boundary[name] for name in names]
    data = {
        "topology": 0,
        "node_x": mesh.points[:, 0],
        "node_z": mesh.points[:, 1],
        "face_node": mesh.triangles,
        "face_zone": mesh.zone,
        "face_quality": quality(mesh.points, mesh.triangles),
        "face_angle": smallest_angle(mesh.points, mesh.triangles),
        "edge_node": np.concatenate(edges),
        "edge_boundary": np.repeat([BOUNDARIES.index(n) for n in names], [len(e) for e in edges]),
        "boundary": list(BOUNDARIES),
        "moved_x": moved[:, 0],
        "moved_z": moved[:, 1],
        "moved_quality": quality(moved, mesh.triangles),
        **{f"moved_{mode}": value for mode, value in zip(MODES, q, strict=True)},
        "order": mesh.order,
        **coarse_variables(mesh.submesh),
        "moved_corner_x": mesh.submesh.positions(q)[:, 0],
        "moved_corner_z": mesh.submesh.positions(q)[:, 1],
    }
    dataset = build(MESH, data)
    dataset["topology"].attrs.update(_TOPOLOGY)
    for name in ("face_node", "edge_node", "zone_corner"):
        dataset[name].attrs["start_index"] = 0
    dataset["edge_boundary"].attrs["flag_meanings"] = " ".join(BOUNDARIES)
    return dataset


def coarse_variables(submesh: Submesh) -> dict[str, object]:
    """Variables of the coarse triangulation and of its motion."""
    anchors = submesh.motion.anchors
    return {
        "corner_x": submesh.rest[:, 0],
        "corner_z": submesh.rest[:, 1],
        "corner_role": anchors.role,
        "corner_partner": anchors.partner,
        "corner_slope": anchors.slope,
        "zone_corner": submesh.triangles,
        "hull_corner": submesh.hull,
        "keel_corner": submesh.keel,
        "bed_x": submesh.bed[:, 0],
        "bed_z": submesh.bed[:, 1],
        "center": submesh.motion.center,
        "axis": ["x", "z"],
        "limits": astuple(submesh.limits),
        "limit": list(Limits.__annotations__),
    }


def from_dataset(dataset: xr.Dataset, modes: tuple[str, ...] = MODES) -> Mesh:
    """The mesh in a dataset of kind `mesh`, with its motion in `modes`."""
    edges, kind = dataset["edge_node"].values, dataset["edge_boundary"].values
    return Mesh(
        submesh_from(dataset, modes),
        _pair(dataset, "node_x", "node_z"),
        dataset["face_node"].values,
        dataset["face_zone"].values,
        {name: edges[kind == i] for i, name in enumerate(BOUNDARIES)},
        2 if int(dataset["order"]) == 2 else 1,
    )


def submesh_from(dataset: xr.Dataset, modes: tuple[str, ...]) -> Submesh:
    """The coarse triangulation in a dataset that holds `coarse_variables`."""
    limits = Limits(*dataset["limits"].values.tolist())
    anchors = Anchors(*(dataset[f"corner_{n}"].values for n in ("role", "partner", "slope")))
    rest = _pair(dataset, "corner_x", "corner_z")
    motion = RigidMotion(rest, anchors, dataset["center"].values, limits.level)
    zones, hull, keel = (dataset[f"{name}_corner"].values for name in ("zone", "hull", "keel"))
    return Submesh(zones, motion, hull, keel, _pair(dataset, "bed_x", "bed_z"), limits, modes)


def _pair(dataset: xr.Dataset, x: str, z: str) -> Vector:
    return np.column_stack([dataset[x].values, dataset[z].values])
