"""The mesh's lines, sent once: each coarse triangle carries its own by an affine map a frame."""

import numpy as np
import rerun as rr
from numpy.typing import NDArray

from squat.quantities import Vector
from squat.replay import scene
from squat.replay.recorder import Recorder
from squat.replay.runs import Run
from squat.replay.style import rgba

_COLOR = "#00000040"
_POINTS = 0.5


def draw_wires(recorder: Recorder, path: str, run: Run, points: Vector) -> None:
    """Lines of the mesh with nodes at `points` (time, node, 2), by zone, if the file has zones."""
    fields = run.fields
    if fields is None or "face_zone" not in fields:
        return
    faces, zone = fields["face_node"].values, fields["face_zone"].values
    layer = scene.raised(float(np.ptp(points[0, :, 0]))) / 2
    clock = run.clock(np.asarray(fields["time"].values, float))
    for number in np.unique(zone):
        lines = edges(faces[zone == number])
        nodes = np.unique(lines)
        maps, shifts = affine(points[:, nodes])
        origin = f"{path}/zone_{number}"
        strips = rr.LineStrips3D.columns(strips=list(scene.placed(points[0, lines], layer)))
        # At the start, not at all times: what is static could not be cleared after the run's end.
        recorder.rows(origin, clock.at([0]), strips.partition([len(lines)]))
        style = rr.LineStrips3D.columns(
            colors=rgba(_COLOR), radii=rr.Radius.ui_points([_POINTS / 2])
        )
        recorder.static(origin, style)
        recorder.rows(
            origin,
            clock,
            rr.Transform3D.columns(translation=scene.placed(shifts), mat3x3=_in_space(maps)),
        )


def edges(faces: NDArray[np.int64]) -> NDArray[np.int64]:
    """Sides (k, 2) of triangles (m, 3), each once."""
    sides = np.concatenate([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]])
    return np.unique(np.sort(sides, axis=1), axis=0)


def affine(points: Vector) -> tuple[Vector, Vector]:
    """Matrices (time, 2, 2) and shifts (time, 2) from the first row of (time, n, 2) to each row."""
    start = points[0].astype(float)
    design = np.column_stack([start, np.ones(len(start))])
    flat = np.moveaxis(points.astype(float), 1, 0).reshape(len(start), -1)
    found = np.linalg.lstsq(design, flat, rcond=None)[0].reshape(3, -1, 2)
    return np.moveaxis(found[:2], 0, 2), found[2]


def _in_space(maps: Vector) -> NDArray[np.float32]:
    """Maps (time, 2, 2) of x and z as maps (time, 3, 3) of the space that holds them."""
    full = np.zeros((len(maps), 3, 3), np.float32)
    full[:, 1, 1] = 1
    for i, row in enumerate((0, 2)):
        for j, column in enumerate((0, 2)):
            full[:, row, column] = maps[:, i, j]
    return full
