"""Pictures of a vertical section: a 3D view that looks straight at the plane of x and z."""

import math

import numpy as np
import rerun as rr
import rerun.blueprint as rrb

from squat.quantities import Vector
from squat.replay.recorder import Recorder
from squat.replay.style import COLORMAP, PALE, colors, rgba

_HALF_VIEW = math.tan(math.radians(55 / 2))  # the viewer's field of view, from top to bottom
_RAISED = 0.002  # of the picture's width: lines stand before the surfaces they lie on


def placed(points: Vector, layer: float = 0.0) -> Vector:
    """Points (..., 2) of the section as (..., 3), `layer` [m] towards the eye."""
    return np.stack(
        [points[..., 0], np.full(points.shape[:-1], -layer), points[..., 1]], axis=-1
    ).astype(np.float32)


def section_view(
    path: str, name: str, low: Vector, high: Vector, aspect: float, stretched: bool = False
) -> rrb.View:
    """View of the rectangle from `low` to `high` (2,) in a window of `aspect` width over height.

    Where the entity `path` is `stretched` by a transform, the view stands outside of that.
    """
    x, z = (low + high) / 2
    distance = seen_width(low, high, aspect) / aspect / (2 * _HALF_VIEW)
    return rrb.Spatial3DView(
        origin="/" if stretched else path,
        contents=f"{path}/**",
        name=name,
        line_grid=rrb.LineGrid3D(visible=False),
        eye_controls=rrb.EyeControls3D(
            kind=rrb.Eye3DKind.Orbital,
            position=[x, -distance, z],
            look_target=[x, 0, z],
            eye_up=[0, 0, 1],
        ),
    )


def seen_width(low: Vector, high: Vector, aspect: float) -> float:
    """Width [m] that a window of `aspect` shows with the whole rectangle from `low` to `high`."""
    width, height = high - low
    return float(max(width, height * aspect))


def raised(width: float) -> float:
    """Layer [m] of lines in a picture of `width` [m]."""
    return _RAISED * width


def lines(recorder: Recorder, path: str, strips: list[Vector], color: str, points: float) -> None:
    """Lines (n, 3) that stand still, `points` wide on the screen."""
    columns = rr.LineStrips3D.columns(strips=strips).partition([len(strips)])
    recorder.static(path, rr.ComponentColumnList([*columns, *look(color, points)]))


def look(color: str, points: float) -> rr.ComponentColumnList:
    """Colour and width on the screen of lines."""
    return rr.LineStrips3D.columns(colors=rgba(color), radii=rr.Radius.ui_points([points / 2]))


def texts(recorder: Recorder, path: str, points: Vector, words: list[str]) -> None:
    """Words that are always shown, at points (n, 3)."""
    count = len(points)
    columns = rr.Points3D.columns(
        positions=points,
        labels=words,
        colors=rgba(*[PALE] * count),
        radii=rr.Radius.ui_points([0.0] * count),
    )
    shown = rr.Points3D.columns(show_labels=[True])
    recorder.static(path, rr.ComponentColumnList([*columns.partition([count]), *shown]))


def color_bar(
    recorder: Recorder,
    path: str,
    corners: tuple[Vector, Vector],
    limits: tuple[float, float],
    places: Vector,
    words: list[str],
) -> None:
    """Bar of the colour map between two opposite corners (2,), `words` below it at x `places`."""
    (x0, z0), (x1, z1) = corners
    x = np.linspace(x0, x1, 65)
    rows = [np.column_stack([x, np.full_like(x, z)]) for z in (z0, z1)]
    shade = colors(np.linspace(*limits, 65), limits)
    strip(recorder, f"{path}/{COLORMAP}", rows[0], rows[1], np.concatenate([shade, shade]))
    below = np.column_stack([places, np.full(len(places), 1.5 * z0 - 0.5 * z1)])
    texts(recorder, f"{path}/numbers", placed(below), words)


def strip(
    recorder: Recorder, path: str, lower: Vector, upper: Vector, shade: Vector | None = None
) -> None:
    """Band between two lines (n, 2); `shade` (2 n, 4): colours of the points, the lower first."""
    count = len(lower)
    recorder.static(path, _band(count))
    points = placed(np.concatenate([lower, upper]))
    recorder.static(path, rr.Mesh3D.columns(vertex_positions=points).partition([2 * count]))
    if shade is not None:
        recorder.static(path, rr.Mesh3D.columns(vertex_colors=shade).partition([2 * count]))


def _band(count: int) -> rr.ComponentColumnList:
    return rr.Mesh3D.columns(triangle_indices=band(count)).partition([2 * (count - 1)])


def band(count: int) -> Vector:
    """Triangles (2 (n - 1), 3) between two lines of `count` points, numbered in turn."""
    n = np.arange(count - 1)
    lower = np.stack([n, n + 1, n + 1 + count], axis=1)
    upper = np.stack([n, n + 1 + count, n + count], axis=1)
    return np.concatenate([lower, upper])
