"""Figures 11 to 13: the coupled runs."""

import json
from typing import Any

import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from squat.errors import InputError
from squat.figures.labels import of_ships
from squat.figures.style import BLUE, GREEN, ORANGE, PURPLE, RED, single
from squat.stability.keel import keel_pressure

_FAILED = {"diverged": "diverged", "iteration limit": "reached the iteration limit"}


def fig11(*runs: xr.Dataset) -> Figure:
    """Heave with both roots of (27) dashed, and pitch where it is free, beside the iterations."""
    plan: list[Any] = [
        [f"{name} {n}", f"iterations {n}"] for n, run in enumerate(runs) for name in _free(run)
    ]
    figure = Figure(figsize=(9.0, 2.3 * len(plan) + 0.4), layout="constrained")
    panels = figure.subplot_mosaic(plan)
    for n, (run, label) in enumerate(zip(runs, of_ships(runs), strict=True)):
        _heave(panels[f"heave {n}"], run)
        panels[f"heave {n}"].set_title(f"{label}: {run.attrs['status']}", loc="left")
        _iterations(panels[f"iterations {n}"], run)
        if f"pitch {n}" in panels:
            panels[f"pitch {n}"].plot(run["phase"], np.rad2deg(run["pitch"]), color=PURPLE)
            panels[f"pitch {n}"].set_ylabel("pitch, bow down [°]")
    for name, axes in panels.items():
        axes.set_xlim(0, 6 * np.pi)
        if name in plan[-1]:
            axes.set_xlabel("$\\omega t$ [-]")
    handles = panels["heave 0"].get_legend_handles_labels()
    figure.legend(*handles, loc="outside upper center", ncols=3)
    return figure


def _free(run: xr.Dataset) -> list[str]:
    return ["heave", "pitch"] if "pitch" in run.attrs["modes"].split() else ["heave"]


def _heave(axes: Axes, run: xr.Dataset) -> None:
    start = "o" if run.sizes["time"] == 1 else None
    axes.plot(run["phase"], run["heave"], marker=start, color=BLUE, label="heave $w$")
    for name, color in (("stable", GREEN), ("unstable", RED)):
        root = float(run[f"{name}_root"])
        axes.axhline(root, color=color, ls="--", lw=1, label=f"{name} root, Eq. (27)")
    axes.set_ylabel("$w$ [m]")


def _iterations(axes: Axes, run: xr.Dataset) -> None:
    axes.set_ylabel("iterations [-]")
    if run.sizes["time"] == 1:
        said = f"no step was accepted:\nthe first {_FAILED.get(run.attrs['status'], 'failed')}"
        axes.text(0.5, 0.5, said, transform=axes.transAxes, ha="center", va="center")
        axes.set_yticks([])
        return
    axes.plot(run["phase"][1:], run["iterations"][1:], ".", ms=4, color=BLUE)
    axes.set_ylim(0, 1.1 * float(run["iterations"].max()) + 1)


def fig12(run: xr.Dataset) -> Figure:
    """Dynamic pressure under the keel at the end of a run, beside the 1D value."""
    if "hull_pressure" not in run:
        raise InputError(
            f"data: model={run.attrs['model']} has no pressure; give a run with model=full"
        )
    figure, axes = single(7.0, 4.2)
    config = json.loads(run.attrs["config"])
    water, channel, hull = config["water"], config["channel"], config["hull"]
    keel = run["hull_z"].values <= float(run["hull_z"].min()) + 1e-9
    end = run.isel(time=-1)
    gap = channel["depth"] - hull["draft"] + float(end["heave"])
    static = water["density"] * water["gravity"] * (channel["depth"] - gap)
    order = np.argsort(run["hull_x"].values[keel])
    x = run["hull_x"].values[keel][order]
    axes.plot(
        x,
        (end["hull_pressure"].values[keel][order] - static) / 1000,
        color=BLUE,
        label="2D (the corners are singular)",
    )
    speed = run.attrs["current"]
    one = float(keel_pressure(water["density"], speed, channel["depth"], gap))
    ends = run["hull_x"].values.min(), run["hull_x"].values.max()
    axes.plot(ends, [one / 1000] * 2, color=RED, ls="--", label="1D, uniform under the hull")
    axes.set_xlabel("$x$ from the bow [m]")
    axes.set_ylabel("pressure less hydrostatic [kPa]")
    title = f"$V_\\infty$ = {speed:g} m/s, $\\omega t$ = {float(end['phase']):.2f}"
    axes.set_title(f"{title}, $w$ = {float(end['heave']):.3f} m", fontsize=10)
    axes.set_ylim(3 * one / 1000, 0.2)
    axes.legend()
    return figure


def fig13(*runs: xr.Dataset) -> Figure:
    """Energies over E_0 against phase; solid the first run, dashed the second."""
    figure, axes = single(7.4, 4.6)
    labels = {"kinetic_energy": "$E_c$", "potential_energy": "$E_p$", "fluid_work": "$W$"}
    colors = (RED, BLUE, GREEN)
    for run, ship, style in zip(runs, of_ships(runs), ("-", "--", ":"), strict=False):
        initial = float(run["kinetic_energy"][0] + run["potential_energy"][0])
        total = np.zeros(run.sizes["time"])
        for (name, label), color in zip(labels.items(), colors, strict=True):
            part = run[name].values / initial
            total += part
            axes.plot(run["phase"], part, style, color=color, label=f"{label}, {ship}")
        axes.plot(run["phase"], total, style, color=ORANGE, label=f"sum, {ship}")
    axes.set_xlabel("$\\omega t$ [-]")
    axes.set_ylabel("energy over $E_0$ [-]")
    figure.legend(loc="outside right upper", fontsize=8)
    return figure
