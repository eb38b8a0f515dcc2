"""Figures 5 and 6, and mesh quality: coarse mesh, fine mesh, both at rest and moved."""

import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.tri import Triangulation

from squat.figures.style import BLUE, ORANGE, RED, depth_axis, stretch


def fine(axes: Axes, data: xr.Dataset, prefix: str = "node") -> None:
    """The fine mesh, at rest (`node`) or `moved`."""
    faces = data["face_node"].values
    axes.triplot(data[f"{prefix}_x"], data[f"{prefix}_z"], faces, color=BLUE, lw=0.25)


def coarse(axes: Axes, data: xr.Dataset, prefix: str = "corner", color: str = RED) -> None:
    """The coarse mesh, at rest (`corner`) or `moved_corner`."""
    zones = data["zone_corner"].values
    axes.triplot(data[f"{prefix}_x"], data[f"{prefix}_z"], zones, color=color, lw=1.1)


def fig5(data: xr.Dataset) -> Figure:
    """The two ideas of the MSA: a coarse mesh that deforms, and interpolation inside it."""
    figure = Figure(figsize=(8.0, 4.8), layout="constrained")
    above, below = figure.subplots(2, 1)
    coarse(above, data, color="0.6")
    coarse(above, data, "moved_corner")
    above.set_title(
        f"(a) coarse mesh at rest (grey) and moved (orange): {_place(data)}", fontsize=10
    )
    _channel(above)
    zone = _example(data)
    _interpolation(below, data, zone)
    return figure


def fig6(data: xr.Dataset) -> Figure:
    """The steps of the MSA: fine mesh, zones, moved zones, moved fine mesh."""
    figure = Figure(figsize=(8.0, 6.8), layout="constrained")
    axes = figure.subplots(4, 1, sharex=True, sharey=True)
    sizes = data.sizes
    fine(axes[0], data)
    axes[0].set_title(f"step 1: fine mesh, {sizes['node']} nodes, {sizes['face']} triangles")
    fine(axes[1], data)
    coarse(axes[1], data)
    axes[1].set_title(f"step 2: {sizes['zone']} zones, edges embedded in the fine mesh")
    coarse(axes[2], data, "moved_corner")
    axes[2].set_title(f"step 3: zones moved, {_place(data)}")
    fine(axes[3], data, "moved")
    axes[3].set_title("step 4: fine mesh moved with its zones")
    for each in axes:
        each.title.set_fontsize(10)
        _channel(each)
        each.label_outer()
    return figure


def mesh_quality(data: xr.Dataset) -> Figure:
    """Shape of the triangles at rest and moved: where, and how many."""
    figure = Figure(figsize=(8.0, 6.4), layout="constrained")
    grid = figure.add_gridspec(3, 1, height_ratios=(1, 1, 1.2))
    panels = [figure.add_subplot(grid[i]) for i in range(3)]
    cases = (("node", "face_quality", "at rest"), ("moved", "moved_quality", _place(data)))
    for axes, (prefix, name, label) in zip(panels, cases, strict=False):
        faces = data["face_node"].values
        mesh = Triangulation(data[f"{prefix}_x"].values, data[f"{prefix}_z"].values, faces)
        drawn = axes.tripcolor(mesh, data[name].values, vmin=0, vmax=1, cmap="viridis")
        axes.set_title(f"{label}: least {float(data[name].min()):.2g}", fontsize=10)
        _channel(axes)
    figure.colorbar(drawn, ax=panels[:2], label="quality [-]")
    bins = np.linspace(0, 1, 41).tolist()
    for (_, name, label), color in zip(cases, (BLUE, ORANGE), strict=True):
        panels[2].hist(data[name], bins=bins, histtype="step", color=color, lw=1.5, label=label)
    panels[2].set_yscale("log")
    panels[2].set_xlabel("quality: $4\\sqrt{3}$ area / sum of squared sides [-]; 1: equilateral")
    panels[2].set_ylabel("triangles [-]")
    panels[2].legend(loc="upper left")
    return figure


def _channel(axes: Axes) -> None:
    axes.grid(visible=False)
    axes.set_xlabel("$x$ [m]")
    depth_axis(axes, stretch(axes.dataLim.width, axes.dataLim.height))


def _place(data: xr.Dataset) -> str:
    surge, heave, pitch = (float(data[f"moved_{mode}"]) for mode in ("surge", "heave", "pitch"))
    parts = [f"surge {surge:g} m"] if surge else []
    return ", ".join([*parts, f"heave {heave:g} m", f"pitch {np.rad2deg(pitch):.3g}°"])


def _example(data: xr.Dataset) -> int:
    """The zone at the bow's foot that holds most nodes."""
    foot = data["hull_corner"].values[0]
    zones = data["zone_corner"].values
    count = np.bincount(data["face_zone"].values, minlength=len(zones))
    return int(np.argmax(np.where((zones == foot).any(axis=1), count, -1)))


def _interpolation(axes: Axes, data: xr.Dataset, zone: int) -> None:
    """One zone and its nodes, at rest and moved, tied by the displacement of some of them."""
    faces = data["face_node"].values[data["face_zone"].values == zone]
    nodes = np.unique(faces)
    corners = data["zone_corner"].values[zone]
    loop = [*corners, corners[0]]
    rest = data["node_x"].values, data["node_z"].values
    moved = data["moved_x"].values, data["moved_z"].values
    for (x, z), prefix, color in ((rest, "corner", "0.6"), (moved, "moved_corner", RED)):
        axes.triplot(x, z, faces, color=color, lw=0.3)
        at = (data[f"{prefix}_{axis}"].values[loop] for axis in "xz")
        axes.plot(*at, "o-", color=color, clip_on=False)
    some = nodes[:: max(1, len(nodes) // 25)]
    axes.quiver(
        rest[0][some],
        rest[1][some],
        *(m[some] - r[some] for m, r in zip(moved, rest, strict=True)),
        angles="xy",
        scale_units="xy",
        scale=1,
        units="inches",
        width=0.014,
        color=BLUE,
    )
    axes.set_title(
        "(b) one zone: its nodes move by the weighted displacement of its three corners",
        fontsize=10,
    )
    _channel(axes)
