"""Figures 11 to 13: the coupled runs."""

import json

import numpy as np
import xarray as xr
from matplotlib.figure import Figure

from squat.errors import InputError
from squat.figures.style import BLUE, GREEN, ORANGE, RED, single
from squat.stability.keel import keel_pressure


def fig11(*runs: xr.Dataset) -> Figure:
    """Heave with both roots of (27) dashed, beside the iterations of every step."""
    figure = Figure(figsize=(9.0, 2.3 * len(runs) + 0.4), layout="constrained")
    panels = figure.subplots(len(runs), 2, squeeze=False)
    for (left, right), run in zip(panels, runs, strict=True):
        left.plot(run["phase"], run["heave"], color=BLUE, label="heave $w$")
        for name, color in (("stable", GREEN), ("unstable", RED)):
            root = float(run[f"{name}_root"])
            left.axhline(root, color=color, ls="--", lw=1, label=f"{name} root, Eq. (27)")
        left.set_title(f"$V_\\infty$ = {run.attrs['current']:g} m/s: {run.attrs['status']}")
        left.set_ylabel("$w$ [m]")
        right.plot(run["phase"][1:], run["iterations"][1:], ".", ms=4, color=BLUE)
        right.set_ylabel("iterations [-]")
        right.set_ylim(0, 1.1 * float(run["iterations"].max()) + 1)
        for axes in (left, right):
            axes.set_xlim(0, 6 * np.pi)
    for axes in panels[-1]:
        axes.set_xlabel("$\\omega t$ [-]")
    figure.legend(*panels[0, 0].get_legend_handles_labels(), loc="outside upper center", ncols=3)
    return figure


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
    axes.axhline(one / 1000, color=RED, ls="--", label="1D, uniform under the hull")
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
    for run, style in zip(runs, ("-", "--", ":"), strict=False):
        initial = float(run["kinetic_energy"][0] + run["potential_energy"][0])
        total = np.zeros(run.sizes["time"])
        speed = f"$V_\\infty$ = {run.attrs['current']:g} m/s"
        for (name, label), color in zip(labels.items(), colors, strict=True):
            part = run[name].values / initial
            total += part
            axes.plot(run["phase"], part, style, color=color, label=f"{label}, {speed}")
        axes.plot(run["phase"], total, style, color=ORANGE, label=f"sum, {speed}")
    axes.set_xlabel("$\\omega t$ [-]")
    axes.set_ylabel("energy over $E_0$ [-]")
    figure.legend(loc="outside right upper", fontsize=8)
    return figure
