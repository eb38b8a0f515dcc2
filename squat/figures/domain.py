"""Figures 3 and 8: the domain with its boundaries, and its dimensions, from the mesh itself."""

from typing import Any

import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.tri import Triangulation

from squat.figures.style import (
    BLUE,
    GREEN,
    ORANGE,
    PURPLE,
    RED,
    SKY,
    depth_axis,
    single,
    stretch,
)
from squat.quantities import Vector

COLORS = {"In": BLUE, "Out": GREEN, "Botm": ORANGE, "FreeS": SKY, "Ship": RED}


def edges(data: xr.Dataset, name: str) -> tuple[Vector, Vector]:
    """x and z of a boundary's edges, each of shape (2, k)."""
    index = data["boundary"].values.tolist().index(name)
    nodes = data["edge_node"].values[data["edge_boundary"].values == index]
    return data["node_x"].values[nodes].T, data["node_z"].values[nodes].T


def scene(axes: Axes, data: xr.Dataset) -> None:
    """The boundaries in their colours, room around."""
    for name, color in COLORS.items():
        x, z = edges(data, name)
        axes.plot(x, z, color=color, lw=3, solid_capstyle="round")
    span, height = np.ptp(data["node_x"].values), np.ptp(data["node_z"].values)
    axes.set(xlim=_margin(data["node_x"], 0.06 * span), ylim=_margin(data["node_z"], 0.45 * height))
    axes.set_xlabel("distance from the bow $x$ [m]")
    depth_axis(axes, stretch(span, height), "height $z$")


def panel(data: xr.Dataset) -> tuple[Figure, Axes]:
    """A figure as high as the channel in it demands."""
    span, height = np.ptp(data["node_x"].values), np.ptp(data["node_z"].values)
    return single(8.0, float(np.clip(12.5 * stretch(span, height) * height / span + 1.2, 2.8, 10)))


def fig3(data: xr.Dataset) -> Figure:
    """Fluid domain with its named boundaries."""
    figure, axes = panel(data)
    faces = data["face_node"].values
    water = Triangulation(data["node_x"].values, data["node_z"].values, faces)
    axes.tripcolor(water, np.zeros(len(faces)), cmap="Blues", vmin=-1, vmax=6)
    scene(axes, data)
    span, height = np.ptp(data["node_x"].values), np.ptp(data["node_z"].values)
    for name, (dx, dz) in {
        "In": (-0.03, 0),
        "Out": (0.03, 0),
        "Botm": (0, -0.15 * height),
        "Ship": (0, 0.1 * height),
    }.items():
        x, z = edges(data, name)
        axes.text(
            x.mean() + dx * span,
            (z.min() if name == "Botm" else z.mean()) + dz,
            name,
            color=COLORS[name],
            ha="center",
            va="center",
            rotation=90 if dx else 0,
        )
    x, z = edges(data, "FreeS")
    ship = edges(data, "Ship")[0]
    for part in (x < ship.mean(), x > ship.mean()):
        axes.text(
            x[part].mean(),
            z.max() + 0.15 * height,
            "FreeS",
            color=COLORS["FreeS"],
            ha="center",
            va="center",
        )
    axes.text(0.5 * (x.min() + ship.min()), 0.5 * z.max(), r"$\Omega$", fontsize=14, va="center")
    axes.set_title("fluid domain $\\Omega$ and its boundaries", fontsize=10)
    return figure


def fig8(data: xr.Dataset) -> Figure:
    """Topology and dimensions, measured on the mesh."""
    figure, axes = panel(data)
    scene(axes, data)
    ship_x, ship_z = edges(data, "Ship")
    left, right = data["node_x"].values.min(), data["node_x"].values.max()
    top, keel = edges(data, "FreeS")[1].max(), ship_z.min()
    surface = ship_x[ship_z == top]
    bow, stern = surface.min(), surface.max()
    deck, low = 1.15 * top, float(data["bed_z"].min()) - 0.4 * top
    _measure(axes, (bow, deck), (stern, deck), f"$L$ = {stern - bow:.4g} m", "above")
    _measure(axes, (left, low), (bow, low), f"$D_{{in}}$ = {bow - left:.4g} m", "below")
    _measure(axes, (stern, low), (right, low), f"$D_{{out}}$ = {right - stern:.4g} m", "below")
    middle = float(ship_x[ship_z == keel].mean())
    bed = float(np.interp(middle, data["bed_x"], data["bed_z"]))
    _measure(
        axes, (middle, keel), (middle, top), f"$T$ = {top - keel:.4g} m", _inside(middle, surface)
    )
    _measure(axes, (middle, bed), (middle, keel), f"$UKC$ = {keel - bed:.4g} m", "foot")
    at = left - 0.02 * (right - left)
    floor = float(np.interp(left, data["bed_x"], data["bed_z"]))
    _measure(axes, (at, floor), (at, top), f"$H$ = {top - floor:.4g} m", "left")
    axes.axhline(top, color=PURPLE, lw=0.8, ls=":")
    axes.set_ylim(low - 0.3 * top, None)
    axes.set_title("topology and dimensions at rest", fontsize=10)
    return figure


_NEAR_THE_MIDDLE = 0.3  # of the length: a label has room on either side
_PLACES: dict[str, tuple[float, tuple[float, float], dict[str, Any]]] = {
    "above": (0.5, (0, 3), {"ha": "center", "va": "bottom"}),
    "below": (0.5, (0, -4), {"ha": "center", "va": "top"}),
    "on": (0.5, (0, 0), {"ha": "center", "va": "center", "bbox": {"fc": "w", "lw": 0, "pad": 1}}),
    "before": (0.5, (-3, 0), {"ha": "right", "va": "center"}),
    "behind": (0.5, (3, 0), {"ha": "left", "va": "center"}),
    "left": (0.5, (-3, 0), {"ha": "right", "va": "center", "rotation": 90}),
    "foot": (0.0, (0, -4), {"ha": "center", "va": "top"}),
}
"""Where on its arrow a label is, its offset from there [pt], and how it is set."""


def _inside(x: float, ends: Vector) -> str:
    """Place of a label at an arrow in the hull: on it, or on the side that is away from an end."""
    share = (x - ends.min()) / np.ptp(ends)
    if abs(share - 0.5) < _NEAR_THE_MIDDLE:
        return "on"
    return "behind" if share < 0.5 else "before"


def _measure(
    axes: Axes, start: tuple[float, float], end: tuple[float, float], text: str, place: str
) -> None:
    """An arrow with both its heads, and its label where it crosses neither hull nor bottom."""
    axes.annotate("", end, start, arrowprops={"arrowstyle": "<->", "shrinkA": 0, "shrinkB": 0})
    share, offset, how = _PLACES[place]
    at = start[0] + share * (end[0] - start[0]), start[1] + share * (end[1] - start[1])
    axes.annotate(text, at, offset, textcoords="offset points", **how)


def _margin(values: xr.DataArray, room: float) -> tuple[float, float]:
    return float(values.min()) - room, float(values.max()) + room
