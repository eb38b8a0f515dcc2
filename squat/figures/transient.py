"""Figures 11 to 13: the coupled runs."""

import textwrap
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from squat import records
from squat.errors import InputError
from squat.figures.labels import boxed, flattened, of_ships, said_in, stepless
from squat.figures.style import BLUE, GREEN, ORANGE, PURPLE, RED, single
from squat.quantities import Vector
from squat.stability.keel import breaks, keel_pressure, squat_speed, underside

_SEEN = (0.02, 0.98)  # shares of the pressures between which the axis lies: corners are singular
_ROOT = "root, Eq. (27)"
_FAR = 5.0  # roots over this many spans of the motion would flatten it
_WIDEST = 90  # letters in a line of a title
_FLAT = "bottom flat at the channel's depth"


def fig11(*runs: xr.Dataset) -> Figure:
    """Heave with both roots of (27) dashed, and pitch where it is free, beside the iterations."""
    plan: list[Any] = [
        [f"{name} {n}", f"iterations {n}"] for n, run in enumerate(runs) for name in _free(run)
    ]
    figure = Figure(figsize=(9.0, 2.5 * len(plan) + 0.6), layout="constrained")
    panels = figure.subplot_mosaic(plan)
    root = _root(runs)
    drawn: dict[str, Any] = {}
    for n, (run, label) in enumerate(zip(runs, of_ships(runs), strict=True)):
        heave = panels[f"heave {n}"]
        far = _heave(heave, run, root)
        _seconds(heave, float(run["omega"]))
        title = textwrap.fill(f"{label}: {run.attrs['status']}{_rootless(run)}", _WIDEST)
        heave.set_title(title + far, loc="left")
        handles, labels = heave.get_legend_handles_labels()
        drawn |= dict(zip(labels, handles, strict=True))
        _iterations(panels[f"iterations {n}"], run)
        if f"pitch {n}" in panels:
            panels[f"pitch {n}"].plot(run["phase"], np.rad2deg(run["pitch"]), color=PURPLE)
            panels[f"pitch {n}"].set_ylabel("pitch, bow down [°]")
    end = max(map(_planned, runs))
    for name, axes in panels.items():
        axes.set_xlim(0, end)
        if name in plan[-1]:
            axes.set_xlabel("$\\omega t$ [-]")
    columns = 3 if root == _ROOT else 1
    figure.legend(list(drawn.values()), list(drawn), loc="outside upper center", ncols=columns)
    return figure


def _planned(run: xr.Dataset) -> float:
    """Phase that the run was to reach, or that it reached [-]."""
    periods: float = records.config_of(run)["time"]["periods"]
    return max(2 * np.pi * periods, float(run["phase"][-1]))


def _free(run: xr.Dataset) -> list[str]:
    return ["heave", "pitch"] if "pitch" in run.attrs["modes"].split() else ["heave"]


def _root(runs: Sequence[xr.Dataset]) -> str:
    """What to call a root of Eq. (27), which takes each of the hulls for a box."""
    name = (
        _ROOT if not any(map(boxed, runs)) else "root of Eq. (27), a box of this length and draft"
    )
    return f"{name}, {_FLAT}" if flattened(*runs) else name


def _rootless(run: xr.Dataset) -> str:
    """What to say of a run without a root of Eq. (27)."""
    if np.isfinite(run["stable_root"]):
        return ""
    config = records.config_of(run)
    depth, gravity = config["channel"]["depth"], config["water"]["gravity"]
    limit = squat_speed(depth, depth - config["hull"]["draft"], gravity)
    return f"; no root of Eq. (27) above {limit:.3f} m/s"


def _seconds(axes: Axes, omega: float) -> None:
    """Time along the top, `omega` [rad/s] in the phase below."""
    both: Any = lambda phase: phase / omega, lambda time: time * omega
    top = axes.secondary_xaxis("top", functions=both)
    top.tick_params(labelsize=8)
    top.xaxis.set_major_formatter("{x:g} s")


def _heave(axes: Axes, run: xr.Dataset, called: str) -> str:
    """The motion and its roots; what to say of one that lies too far below to be drawn."""
    start = "o" if run.sizes["time"] == 1 else None
    axes.plot(run["phase"], run["heave"], marker=start, color=BLUE, label="heave $w$")
    seen, far = np.append(run["heave"].values, run["stable_root"]), ""
    for name, color in (("stable", GREEN), ("unstable", RED)):
        root = float(run[f"{name}_root"])
        if np.nanmin(seen) - root > _FAR * np.ptp(seen) > 0:
            far += f"\n{name} root far below, {root:.2f} m"
        elif np.isfinite(root):
            axes.axhline(root, color=color, ls="--", lw=1, label=f"{name} {called}")
    axes.set_ylabel("$w$ [m]")
    return far


def _iterations(axes: Axes, run: xr.Dataset) -> None:
    axes.set_ylabel("iterations [-]")
    if said := stepless(run):
        said_in(axes, said)
        axes.set_yticks([])
        return
    axes.plot(run["phase"][1:], run["iterations"][1:], ".", ms=4, color=BLUE, clip_on=False)
    axes.set_ylim(0, 1.1 * float(run["iterations"].max()) + 1)


def fig12(run: xr.Dataset) -> Figure:
    """Dynamic pressure along the hull's underside at the end of a run, beside the 1D value."""
    if "hull_pressure" not in run:
        raise InputError(
            f"data: model={run.attrs['model']} has no pressure; give a run with model=full"
        )
    figure, axes = single(7.0, 4.2)
    config, end = records.config_of(run), run.isel(time=-1)
    depth, density = config["channel"]["depth"], config["water"]["density"]
    x, pressure = _along(end, depth, density * config["water"]["gravity"])
    gap = depth - config["hull"]["draft"] + float(end["heave"])
    one = float(keel_pressure(density, run.attrs["current"], depth, gap))
    seen = 0.0, one, *np.quantile(pressure, _SEEN)
    room = 0.15 * np.ptp(seen)
    low, high = min(seen) - room, max(seen) + room
    beyond = pressure.min() < low or pressure.max() > high
    apart = breaks(underside(run["hull_x"].values, run["hull_z"].values))
    line = (np.insert(values, apart, np.nan) for values in (x, pressure / 1000))
    axes.plot(*line, color=BLUE, label=f"2D{' (the corners are singular)' if beyond else ''}")
    ends = run["hull_x"].values.min(), run["hull_x"].values.max()
    axes.plot(ends, [one / 1000] * 2, color=RED, ls="--", label=_uniform(run))
    axes.set_xlabel("$x$ from the bow, where the hull is flatter than 45° [m]")
    axes.set_ylabel("pressure less hydrostatic [kPa]")
    title = rf"$V_\infty$ = {run.attrs['current']:g} m/s, $\omega t$ = {float(end['phase']):.2f}"
    noise = ", grounded: noise of the mesh" if run.attrs["status"] == "grounded" else ""
    axes.set_title(f"{title}, $w$ = {float(end['heave']):.3f} m{noise}", fontsize=10)
    axes.set_ylim(low / 1000, high / 1000)
    axes.legend()
    return figure


def _uniform(run: xr.Dataset) -> str:
    """What to call the 1D pressure, with what it takes hull and bottom for."""
    flat = _FLAT if flattened(run) else ""
    return ", ".join(filter(None, ["1D, uniform under the hull", boxed(run), flat]))


def _along(end: xr.Dataset, depth: float, weight: float) -> tuple[Vector, Vector]:
    """Where the underside's nodes are at rest, x [m], and the pressure there at `end` [Pa].

    Less the hydrostatic one, `weight` [N/m3] times the depth of each node as heave and pitch have
    moved it.
    """
    x, z = end["hull_x"].values, end["hull_z"].values
    under = underside(x, z)
    along, above = x[under] - float(end["center"][0]), z[under] - float(end["center"][1])
    heave, pitch = float(end["heave"]), float(end["pitch"])
    height = float(end["center"][1]) + heave + np.sin(pitch) * along + np.cos(pitch) * above
    return x[under], end["hull_pressure"].values[under] - weight * (depth - height)


def fig13(*runs: xr.Dataset) -> Figure:
    """Energies over E_0 against phase, each in its colour; runs, three at most, by dashes."""
    figure, axes = single(7.4, 4.6)
    terms = {"kinetic_energy": "$E_c$", "potential_energy": "$E_p$", "fluid_work": "$W$"}
    colors = dict(zip((*terms.values(), "sum"), (RED, BLUE, GREEN, ORANGE), strict=True))
    named = []
    for run, ship, style in zip(runs, of_ships(runs), ("-", "--", ":"), strict=False):
        said = stepless(run)
        dashes = " " if said else style
        named.append(Line2D([], [], ls=dashes, color="black", label=f"{ship}: {said}".rstrip(": ")))
        if not said:
            _shares(axes, run, {colors[label]: run[name] for name, label in terms.items()}, style)
    if all(map(stepless, runs)):
        axes.set_xticks([])
        axes.set_yticks([])
    axes.set_xlabel("$\\omega t$ [-]")
    axes.set_ylabel("energy over $E_0$ [-]")
    drawn = [Line2D([], [], color=color, label=label) for label, color in colors.items()]
    figure.legend(handles=drawn, loc="outside right upper", fontsize=8)
    figure.legend(handles=named, loc="outside lower center", fontsize=8)
    return figure


def _shares(axes: Axes, run: xr.Dataset, parts: Mapping[str, xr.DataArray], style: str) -> None:
    """Energies over that of the start, by colour, and their sum."""
    initial = float(run["kinetic_energy"][0] + run["potential_energy"][0])
    for color, part in parts.items():
        axes.plot(run["phase"], part / initial, style, color=color)
    axes.plot(run["phase"], sum(parts.values()) / initial, style, color=ORANGE)
