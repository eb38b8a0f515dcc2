"""Snapshots of the water: the moving mesh in the colours of its pressure, velocity as arrows."""

from typing import NamedTuple

import numpy as np
import rerun as rr
import xarray as xr
from numpy.typing import NDArray
from scipy.spatial import KDTree

from squat.quantities import Vector
from squat.replay import scene
from squat.replay.recorder import Recorder
from squat.replay.runs import Run
from squat.replay.style import colors, rgba, ticks
from squat.replay.wires import draw_wires

_SEEN = (0.05, 0.98)  # shares of the nodes between which colours differ: corners are singular
_APART = 0.22  # of the colour bar, which a number beside that of an end needs
_LEVELS = 5  # rows of arrows over the depth
_ARROW = 0.8  # length of the current's arrow over their distance
_WHITE = "#FFFFFFCC"


def snapshot_times(fields: xr.Dataset) -> Vector:
    """Times of the snapshots [s]."""
    return np.asarray(fields["time"].values, float)


class Scales(NamedTuple):
    """What colours and arrows mean, in all runs of a recording.

    Ends of the colours, least and greatest pressure [kPa]; speed [m/s] of an arrow's length.
    """

    limits: tuple[float, float]
    seen: tuple[float, float]
    speed: float

    @classmethod
    def of(cls, runs: tuple[Run, ...]) -> "Scales | None":
        """Scales common to all `runs`; None where none of them has snapshots."""
        shown = [run for run in runs if run.fields is not None]
        if not shown:
            return None
        values = np.concatenate([dynamic_pressure(run).ravel() for run in shown])
        speed = max(float(run.data.attrs["current"]) for run in shown)
        seen = float(np.nanmin(values)), float(np.nanmax(values))
        return cls(color_limits(values), seen, speed or _greatest_speed(shown) or 1.0)


def _greatest_speed(runs: list[Run]) -> float:
    return max(
        float(np.nanmax(np.abs(run.fields[f"velocity_{axis}"].values)))
        for run in runs
        if run.fields is not None
        for axis in "xz"
    )


def draw_field(
    recorder: Recorder, origin: str, run: Run, ends: tuple[float, float], scales: Scales
) -> None:
    """Send mesh, colour bar and arrows of a run with snapshots below `origin`.

    `ends` [m] are those of the picture.
    """
    fields = run.fields
    assert fields is not None
    depth = float(run.config["channel"]["depth"])
    pressure, limits = dynamic_pressure(run), scales.limits
    points = np.stack([fields["x"].values, fields["z"].values], axis=-1)
    _mesh(recorder, f"{origin}/mesh", run, points, pressure, limits)
    draw_wires(recorder, f"{origin}/wires", run, points)
    words = bar_numbers(limits, scales.seen)
    _legend(recorder, f"{origin}/color_bar", depth, ends, limits, words)
    _arrows(recorder, f"{origin}/velocity", run, points, depth / _LEVELS, scales.speed)


def dynamic_pressure(run: Run) -> Vector:
    """Pressure less p_atm + rho g (H - z) at the nodes, (time, node) [kPa]."""
    assert run.fields is not None
    water, depth = run.config["water"], run.config["channel"]["depth"]
    head = water["density"] * water["gravity"] * (depth - run.fields["z"].values)
    return np.asarray(run.fields["pressure"].values - head) / 1000


def color_limits(pressure: Vector) -> tuple[float, float]:
    """Ends of the colours for these pressures [kPa]."""
    low, high = np.nanquantile(pressure, _SEEN)
    return (float(low), float(high)) if high > low else (float(low) - 0.5, float(low) + 0.5)


def _mesh(
    recorder: Recorder,
    path: str,
    run: Run,
    points: Vector,
    pressure: Vector,
    limits: tuple[float, float],
) -> None:
    """Topology once, then positions and colours of every snapshot."""
    assert run.fields is not None
    faces = run.fields["face_node"].values.astype(np.uint32)
    recorder.static(path, rr.Mesh3D.columns(triangle_indices=faces).partition([len(faces)]))

    def frames(rows: slice) -> rr.ComponentColumnList:
        count, nodes = pressure[rows].shape
        columns = rr.Mesh3D.columns(
            vertex_positions=scene.placed(points[rows]).reshape(-1, 3),
            vertex_colors=colors(pressure[rows], limits).reshape(-1, 4),
        )
        return columns.partition([nodes] * count)

    recorder.frames(path, run.clock(snapshot_times(run.fields)), frames)


def _legend(
    recorder: Recorder,
    path: str,
    depth: float,
    ends: tuple[float, float],
    limits: tuple[float, float],
    words: dict[float, str],
) -> None:
    """Colour bar below the channel, with `words` at their values."""
    middle, half = sum(ends) / 2, 0.3 * (ends[1] - ends[0])
    corners = np.array([middle - half, -0.35 * depth]), np.array([middle + half, -0.25 * depth])
    shares = (np.array([*words]) - limits[0]) / (limits[1] - limits[0])
    places = middle - half + 2 * half * shares
    scene.color_bar(recorder, path, corners, limits, places, [*words.values()])


def bar_numbers(limits: tuple[float, float], seen: tuple[float, float]) -> dict[float, str]:
    """Words [kPa] at round numbers of the colour bar, and at its ends where pressures go beyond.

    `seen` are the least and the greatest pressure.
    """
    low, high = limits
    ends = {}
    if seen[0] < low:
        ends[low] = f"≤ {low:.3g} kPa"
    if seen[1] > high:
        ends[high] = f"≥ {high:.3g} kPa"
    room = _APART * (high - low)
    inner = [n for n in ticks(*limits) if all(abs(n - end) > room for end in ends)]
    return {float(n): f"{n:g} kPa" for n in inner} | ends


def _arrows(
    recorder: Recorder,
    path: str,
    run: Run,
    points: Vector,
    distance: float,
    speed: float,
) -> None:
    """Velocity at nodes near the points of a grid, which move with the mesh."""
    fields = run.fields
    assert fields is not None
    chosen = arrow_nodes(points[0], distance)
    velocity = np.stack([fields[f"velocity_{axis}"].values[:, chosen] for axis in "xz"], axis=-1)
    layer = scene.raised(float(np.ptp(points[0, :, 0])))
    arrows = _ARROW * distance / speed * velocity
    origins = scene.placed(points[:, chosen], layer)
    columns = rr.Arrows3D.columns(
        vectors=scene.placed(arrows).reshape(-1, 3), origins=origins.reshape(-1, 3)
    )
    style = rr.Arrows3D.columns(colors=rgba(_WHITE), radii=rr.Radius.ui_points([1.0]))
    recorder.static(path, style)
    lengths = [len(chosen)] * len(velocity)
    recorder.rows(path, run.clock(snapshot_times(fields)), columns.partition(lengths))


def arrow_nodes(points: Vector, distance: float) -> NDArray[np.int64]:
    """Numbers of the nodes (n, 2) nearest to a grid `distance` apart, each once."""
    low, high = points.min(axis=0), points.max(axis=0)
    axes = [np.arange(a + distance / 2, b, distance) for a, b in zip(low, high, strict=True)]
    grid = np.stack(np.meshgrid(*axes), axis=-1).reshape(-1, 2)
    far, nearest = KDTree(points).query(grid)
    return np.unique(np.asarray(nearest, np.int64)[far < distance / 2])
