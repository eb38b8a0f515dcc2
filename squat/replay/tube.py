"""The piston in its U-tube: water column, piston, and where Eq. (5) has it."""

import math

import numpy as np
import rerun as rr
import rerun.blueprint as rrb

from squat.quantities import Vector
from squat.replay import scene
from squat.replay.panels import Place, panel, picture_aspect
from squat.replay.recorder import Recorder, entity
from squat.replay.runs import Run
from squat.replay.style import BLUE, GREY, ORANGE, PALE, rgba

# Proportions of the sketch, in lengths of the water column.
_BORE, _APART, _LEG, _WALL, _PISTON = 0.12, 0.5, 0.25, 0.5, 0.08
_SWING = 0.2
_ASPECT = 2.0


@panel("tube", Place.PICTURE, ("position", "exact_position"))
def tube(recorder: Recorder, runs: tuple[Run, ...]) -> list[rrb.View]:
    """One picture a run."""
    aspect = picture_aspect(_ASPECT, len(runs))
    return [_picture(recorder, run, aspect) for run in runs]


def magnification(position: Vector, length: float) -> float:
    """Power of ten by which the motion is drawn larger, so that it shows and stays in the tube."""
    greatest = float(np.abs(position).max()) or length
    return float(10.0 ** math.floor(math.log10(_SWING * length / greatest)))


def _picture(recorder: Recorder, run: Run, aspect: float) -> rrb.View:
    length = float(run.config["piston"]["length"])
    position, exact = run.data["position"].values, run.data["exact_position"].values
    scale = magnification(np.append(position, exact), length)
    origin = entity(run, "tube")
    _walls(recorder, origin, length)
    _column(recorder, origin, run, length, scale * position)
    _exact(recorder, origin, run, length, scale * exact)
    half = (_APART / 2 + _BORE) * length
    low, high = np.array([-half, -0.1 * length]), np.array([half, (_WALL + 0.1) * length])
    title = f"U-tube, motion x {scale:g}; orange: exact piston, Eq. (5)"
    return scene.section_view(f"/{origin}", run.told(title), low, high, aspect)


def _u(length: float, outside: float, left: Vector, right: Vector) -> Vector:
    """Chains (rows, 4, 2) along a U whose legs end at heights `left` and `right` (rows,)."""
    x, floor = (_APART / 2 + outside) * length, -outside * length
    chain = np.zeros((len(left), 4, 2))
    chain[..., 0] = [-x, -x, x, x]
    chain[..., 1] = floor
    chain[:, 0, 1], chain[:, 3, 1] = left, right
    return chain


def _walls(recorder: Recorder, origin: str, length: float) -> None:
    top = np.array([_WALL * length])
    sides = [_u(length, sign * _BORE / 2, top, top)[0] for sign in (-1, 1)]
    strips = [scene.placed(side, scene.raised(length)) for side in sides]
    scene.lines(recorder, f"{origin}/walls", strips, PALE, 3)


def _column(recorder: Recorder, origin: str, run: Run, length: float, displacement: Vector) -> None:
    """Water between both levels, and the piston on the right one."""
    ends = _LEG * length - displacement, _LEG * length + displacement
    water = np.concatenate([_u(length, sign * _BORE / 2, *ends) for sign in (1, -1)], axis=1)
    _moving(recorder, f"{origin}/water", run, water, BLUE)
    x = (_APART / 2 + _BORE / 2 * np.array([-1, 1, -1, 1])) * length
    z = ends[1][:, None] + _PISTON * length * np.array([0, 0, 1, 1])
    piston = np.stack([np.broadcast_to(x, z.shape), z], axis=-1)
    _moving(recorder, f"{origin}/piston", run, piston, GREY)


def _moving(recorder: Recorder, path: str, run: Run, points: Vector, color: str) -> None:
    """A band of one colour through points (rows, n, 2)."""
    rows, count, _ = points.shape
    faces = scene.band(count // 2)
    recorder.static(path, rr.Mesh3D.columns(triangle_indices=faces).partition([len(faces)]))
    recorder.static(path, rr.Mesh3D.columns(albedo_factor=rgba(color)))
    columns = rr.Mesh3D.columns(vertex_positions=scene.placed(points).reshape(-1, 3))
    recorder.rows(path, run.steps, columns.partition([count] * rows))


def _exact(recorder: Recorder, origin: str, run: Run, length: float, displacement: Vector) -> None:
    """Line across the piston's leg where its face should be."""
    x = (_APART / 2 + _BORE * np.array([-1, 1])) * length
    z = np.broadcast_to((_LEG * length + displacement)[:, None], (len(displacement), 2))
    line = np.stack([np.broadcast_to(x, z.shape), z], axis=-1)
    path = f"{origin}/exact"
    recorder.static(path, scene.look(ORANGE, 3))
    strips = list(scene.placed(line, 2 * scene.raised(length)))
    recorder.rows(path, run.steps, rr.LineStrips3D.columns(strips=strips))
