"""What the energies imply: potential, phase portraits, limits over speed, geometry and start."""

import json

import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from squat.figures.style import BLUE, GREEN, ORANGE, PALETTE, PURPLE, RED, single

_LIMITS = (
    ("squat_speed_1d", "1D", ORANGE),
    ("squat_speed_2d", "2D", GREEN),
    ("dynamic_squat_speed", "dynamic", PURPLE),
)


def _bottom(data: xr.Dataset) -> float:
    """Heave at which a box touches the bottom [m]."""
    config = json.loads(data.attrs["config"])
    return float(config["hull"]["draft"] - config["channel"]["depth"])


def potential(data: xr.Dataset) -> Figure:
    """U(w) at several currents: the whole, and the wells with the energy of the start."""
    figure = Figure(figsize=(9.6, 4.4), layout="constrained")
    whole, wells = figure.subplots(1, 2)
    highest, deepest, start = 0.1, 0.0, float(data["start_heave"])
    for n, color in zip(range(data.sizes["case_speed"]), PALETTE, strict=False):
        row = data.isel(case_speed=n)
        heave, curve = row["heave"].values, _above_rest(row)
        level = np.interp(start, heave, curve)
        level += np.interp(start, heave, row["inertia"]) * float(row["start_velocity"]) ** 2 / 2e6
        for axes in (whole, wells):
            axes.plot(heave, curve, color=color, label=f"{float(row['case_speed']):g} m/s")
            for name, face in (("stable", color), ("unstable", "white")):
                w = float(row[f"case_{name}"])
                axes.plot(w, np.interp(w, heave, curve), "o", color=color, mfc=face, zorder=3)
        wells.axhline(level, color=color, lw=1, ls=":")
        places = [float(row[f"case_{name}"]) for name in ("stable", "unstable")]
        ends = np.interp(np.nan_to_num(places), heave, curve)
        highest, deepest = max(highest, *ends), min(deepest, *ends)
    bottom = _bottom(data)
    whole.set(xlim=(bottom, 3), ylim=(-0.4 * highest, 1.1 * highest), ylabel="$U - U(0)$ [MJ/m]")
    room = max(-deepest, 0.02 * highest)
    wells.set(xlim=(0.8 * bottom, 1.5), ylim=(-1.5 * room, 1.5 * room))
    whole.set_title("the whole curve", fontsize=10)
    wells.set_title("the wells; dotted: energy of the start", fontsize=10)
    wells.axvline(start, color="k", lw=1, ls=":", label=f"$w(0)$ = {start:g} m")
    wells.plot([], [], "o", color="k", label="stable")
    wells.plot([], [], "o", color="k", mfc="white", label="unstable")
    for axes in (whole, wells):
        axes.set_xlabel("heave $w$ [m]")
    figure.legend(*wells.get_legend_handles_labels(), loc="outside right upper")
    return figure


def _above_rest(row: xr.Dataset) -> np.ndarray:
    """U(w) - U(0) in MJ/m."""
    values = row["potential"].values
    return np.asarray((values - np.interp(0, row["heave"].values, values)) / 1e6)


def phase_portrait(data: xr.Dataset) -> Figure:
    """Curves of constant energy in the plane of w and w', one panel a current."""
    count = data.sizes["case_speed"]
    rows = (count + 1) // 2
    figure = Figure(figsize=(9.0, 3.1 * rows + 0.5), layout="constrained")
    panels = figure.subplots(rows, 2, sharex=True, squeeze=False)
    for n, axes in enumerate(panels.flat):
        if n >= count:
            axes.set_axis_off()
            continue
        _portrait(axes, data.isel(case_speed=n))
    for axes in panels[-1]:
        axes.set_xlabel("heave $w$ [m]")
    for axes in panels[:, 0]:
        axes.set_ylabel("velocity $\\dot{w}$ [m/s]")
    handles, labels = panels[0, 0].get_legend_handles_labels()
    figure.legend(handles, labels, loc="outside upper center", ncols=5)
    return figure


def _portrait(axes: Axes, data: xr.Dataset) -> None:
    heave, inertia, potential = (data[name].values for name in ("heave", "inertia", "potential"))
    start = float(data["start_heave"]), float(data["start_velocity"])
    own = np.interp(start[0], heave, inertia * start[1] ** 2 / 2 + potential)
    lift = np.where(heave > float(data["case_stable"]), 2 * (own - potential) / inertia, 0)
    loop, edge = data["separatrix_heave"].values, data["separatrix_velocity"].values
    fastest = 1.15 * max(np.nanmax(edge, initial=0.2), np.sqrt(lift.max(initial=0)))
    velocity = np.linspace(-fastest, fastest, 161)
    energy = potential + inertia * velocity[:, None] ** 2 / 2
    well, top = (
        np.interp(float(data[f"case_{name}"]), heave, potential) for name in ("stable", "unstable")
    )
    if np.isfinite(top):
        levels = well + (top - well) * np.array([0.1, 0.3, 0.55, 0.8, 1.25, 1.6, 2.1])
        axes.contour(
            heave, velocity, energy, levels, colors="0.7", linewidths=0.8, linestyles="solid"
        )
    reach = _reach(potential <= own, heave, start[0])
    axes.contour(heave[reach], velocity, energy[:, reach], [own], colors=BLUE, linewidths=1.4,
                 linestyles="solid")  # fmt: skip
    for way, label in ((1, "separatrix"), (-1, None)):
        axes.plot(loop, way * edge, color=RED, lw=1.8, label=label)
    axes.plot([], [], color=BLUE, lw=1.4, label="energy of the start")
    axes.plot(float(data["case_stable"]), 0, "ko", ms=5, label="stable")
    axes.plot(float(data["case_unstable"]), 0, "ko", ms=5, mfc="white", label="unstable")
    axes.plot(*start, "x", color=BLUE, ms=7, label="start")
    axes.set(xlim=(_bottom(data), 3), ylim=(-fastest, fastest))
    speed = float(data["case_speed"])
    limit = float(data["dynamic_squat_speed"])
    end = "is lost" if speed >= limit else "turns"
    axes.set_title(f"$V_\\infty$ = {speed:g} m/s: the start {end}", fontsize=10)


def _reach(admitted: np.ndarray, heave: np.ndarray, start: float) -> slice:
    """The positions that the energy admits without a gap from `start`, and one more either way."""
    inside, outside = np.flatnonzero(admitted), np.flatnonzero(~admitted)
    here = inside[np.abs(heave[inside] - start).argmin()]
    low = outside[outside < here].max(initial=0)
    return slice(low, outside[outside > here].min(initial=len(heave) - 1) + 1)


def limits(data: xr.Dataset) -> Figure:
    """Figure 10 again: 1D and 2D roots, the deepest point reached, and the three limits."""
    figure, axes = single(7.6, 5.0)
    speed = data["speed"].values
    for suffix, style, name in (("_1d", "--", "1D"), ("", "-", "2D")):
        axes.plot(speed, data[f"stable{suffix}"], style, color=BLUE, label=f"{name} stable")
        axes.plot(speed, data[f"unstable{suffix}"], style, color=RED, label=f"{name} unstable")
    start = float(data["start_heave"])
    axes.plot(
        speed, data["lowest"], "-.", color="k", lw=1.2, label=f"deepest, released at {start:g} m"
    )
    for name, label, color in _LIMITS:
        limit = float(data[name])
        axes.axvline(limit, color=color, lw=1.5, label=f"{label} limit {limit:.3f} m/s")
    for name in ("1d", "2d"):
        axes.plot(float(data[f"squat_speed_{name}"]), float(data[f"squat_sinkage_{name}"]), "k.")
    bottom = _bottom(data)
    axes.axhspan(bottom - 0.6, bottom, color="0.85", lw=0, label="below the bottom")
    axes.set(xlim=(speed[0], speed[-1]), ylim=(bottom - 0.6, 0.6))
    axes.set_xlabel("current relative to the ship $V_\\infty$ [m/s]")
    axes.set_ylabel("vertical position $w$ [m]")
    figure.legend(loc="outside upper center", ncols=3)
    return figure


def basins(data: xr.Dataset) -> Figure:
    """Dynamic squat speed over w(0) and w'(0): inside a contour that speed is survived."""
    figure, axes = single(7.0, 4.6)
    heave, velocity = data["initial_heave"].values, data["initial_velocity"].values
    grid = data["limit_map"].values
    both = np.r_[-velocity[:0:-1], velocity]
    mirrored = np.hstack([grid[:, :0:-1], grid])
    fastest = float(data["squat_speed_2d"])
    levels = np.arange(np.floor(5 * np.nanmin(grid)), np.ceil(5 * fastest) + 1) / 5
    shades = axes.contourf(heave, both, mirrored.T, levels, cmap="cividis")
    for n in range(data.sizes["case_speed"]):
        _basin(axes, data.isel(case_speed=n), (heave[0], heave[-1], velocity[-1]))
    axes.plot(float(data["start_heave"]), float(data["start_velocity"]), "kx", ms=8)
    figure.colorbar(shades, ax=axes, format="%.1f", label="dynamic squat speed [m/s]")
    axes.set(xlim=(heave[0], heave[-1]), ylim=(both[0], both[-1]))
    axes.grid(visible=False)
    axes.set_xlabel("$w(0)$ [m]")
    axes.set_ylabel("$\\dot{w}(0)$ [m/s]")
    return figure


def _basin(axes: Axes, data: xr.Dataset, window: tuple[float, float, float]) -> None:
    """The separatrix of one current, labelled at its highest point within the window."""
    loop, edge = data["separatrix_heave"].values, data["separatrix_velocity"].values
    for way in (1, -1):
        axes.plot(loop, way * edge, color="k", lw=1.3)
    seen = np.flatnonzero((loop > window[0]) & (loop < window[1]) & (edge < 0.9 * window[2]))
    if seen.size:
        top = seen[np.argmax(edge[seen])]
        text = f"{float(data['case_speed']):g} m/s"
        axes.annotate(
            text, (loop[top], edge[top]), (0, 3), textcoords="offset points",
            ha="center", va="bottom", fontsize=8,
        )  # fmt: skip


def limits_map(data: xr.Dataset) -> Figure:
    """2D and dynamic limits over the 1D value, over H/T for each L/T."""
    figure = Figure(figsize=(9.4, 4.4), layout="constrained")
    left, right = figure.subplots(1, 2, sharey=True)
    ratio = data["depth_over_draft"].values
    for length, color in zip(data["length_over_draft"].values, PALETTE, strict=False):
        row = data.sel(length_over_draft=length)
        for axes, name in ((left, "limit_2d"), (right, "limit_dynamic")):
            share = row[name] / row["limit_1d"]
            axes.plot(ratio, share, "o-", ms=4, color=color, label=f"$L/T$ = {length:g}")
    start = data.attrs["start_over_draft"]
    titles = ("2D squat speed", f"dynamic squat speed, released at $w(0)$ = {start:g} $T$")
    for axes, title in zip((left, right), titles, strict=True):
        axes.axhline(1, color="k", lw=1, ls="--")
        axes.set_title(title, fontsize=10)
        axes.set_xlabel("$H/T$ [-]")
    left.set_ylabel("limit over the 1D squat speed [-]")
    figure.legend(*left.get_legend_handles_labels(), loc="outside right upper")
    return figure
