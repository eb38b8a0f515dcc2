"""Snapshots of the whole field, derived from the states of a run."""

from collections.abc import Mapping

import numpy as np
import xarray as xr
from numpy.typing import NDArray

from squat.dynamics import Motion
from squat.fluid.pressure import gradients
from squat.fluid.rates import Levels
from squat.quantities import Vector
from squat.transient.parts import Parts

_ATTRIBUTES = {
    "time": ("s", "time of the snapshot"),
    "x": ("m", "x of the moved nodes"),
    "z": ("m", "z of the moved nodes"),
    "potential": ("m2 s-1", "velocity potential phi"),
    "velocity_x": ("m s-1", "water velocity along x, mean of the triangles at a node"),
    "velocity_z": ("m s-1", "water velocity along z, mean of the triangles at a node"),
    "pressure": ("Pa", "pressure less atmospheric, Eq. (20)"),
    "face_node": ("1", "nodes of each triangle, from 0"),
    "face_zone": ("1", "coarse triangle that the triangle lies in and moves with, affinely"),
}


Snapshot = dict[str, NDArray[np.float32]]


def fields(parts: Parts, snapshots: Mapping[int, Snapshot]) -> xr.Dataset:
    """Coordinates, potential, velocity and pressure of the recorded steps, float32."""
    rows = list(snapshots.values())
    data = {name: (("time", "node"), np.array([row[name] for row in rows])) for name in rows[0]}
    dataset = xr.Dataset(
        {
            **data,
            "face_node": (("face", "corner"), parts.fluid.mesh.triangles),
            "face_zone": ("face", parts.fluid.mesh.zone),
        },
        {"time": parts.dt * np.array(list(snapshots))},
    )
    for name, (units, long_name) in _ATTRIBUTES.items():
        dataset[name].attrs.update(units=units, long_name=long_name)
    return dataset


def snapshot(parts: Parts, motion: Motion, levels: Levels) -> Snapshot:
    """Coordinates, potential, velocity and pressure (nodes,) of one state, float32."""
    found = _snapshot(parts, motion, levels)
    return {name: np.asarray(row, np.float32) for name, row in found.items()}


def _snapshot(parts: Parts, motion: Motion, levels: Levels) -> dict[str, Vector]:
    fluid = parts.fluid
    mesh = fluid.mesh
    points = mesh.moved(motion.position)
    slopes = gradients(points[mesh.triangles], levels.now[mesh.triangles])
    count = np.bincount(mesh.triangles.ravel(), minlength=len(points))
    speed = np.stack(
        [
            np.bincount(mesh.triangles.ravel(), np.repeat(slope, 3), minlength=len(points)) / count
            for slope in slopes.T
        ]
    )
    carried = np.tensordot(motion.velocity, mesh.velocities(motion.position), axes=1)
    unsteady = levels.rate - (carried * speed.T).sum(axis=1)
    rho, g = fluid.water.density, fluid.water.gravity
    head = g * (mesh.submesh.limits.level - points[:, 1])
    pressure = rho * (head + (fluid.current**2 - (speed**2).sum(axis=0)) / 2 - unsteady)
    return {
        "x": points[:, 0],
        "z": points[:, 1],
        "potential": levels.now,
        "velocity_x": speed[0],
        "velocity_z": speed[1],
        "pressure": pressure,
    }
