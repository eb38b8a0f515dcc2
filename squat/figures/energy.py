"""The energy of ship, water and the channel's ends: what Fig. 13 shows, and what it leaves out."""

import json
import textwrap
from collections.abc import Sequence

import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from squat.figures.labels import of_ships, said_in, stepless
from squat.figures.style import PALETTE
from squat.quantities import Vector

_SHIP = {
    "kinetic_energy": "ship $m\\dot{w}^2/2$",
    "potential_energy": "weight $mg(T+w)$",
    "fluid_work": "work on the water",
}
_WHOLE = {
    "kinetic_energy": "ship $m\\dot{w}^2/2$",
    "water_energy": "water $T_f$",
    "static_energy": "still water and weight",
    "stream_energy": "stream's head $U_B$",
}
_WIDE = 55  # letters in a line of a panel's title, or of half a legend


def energy_audit(*runs: xr.Dataset) -> Figure:
    """Both balances of the first run, term by term, and what either leaves over in all runs."""
    figure = Figure(figsize=(9.0, 7.6), layout="constrained")
    panels = figure.subplot_mosaic([["ship", "whole"], ["rest", "rest"]])
    first, labels = runs[0], of_ships(runs)
    _balance(panels["ship"], first, _terms(first, _SHIP))
    of = "" if len(runs) == 1 else f"{labels[0]}, first of {len(runs)} runs"
    named = "\n".join(["", *textwrap.wrap(of, _WIDE)])
    panels["ship"].set_title(f"Fig. 13: the ship alone{named}", fontsize=10)
    ends = {"minus work of the ends": -first["end_work"].values}
    _balance(panels["whole"], first, {**_terms(first, _WHOLE), **ends})
    panels["whole"].set_title(f"ship, water and the channel's ends{named}", fontsize=10)
    _left_over(panels["rest"], runs, labels)
    shown = f": {labels[0]}, {_settings(first)}" if len(runs) == 1 else f", {len(runs)} runs"
    figure.suptitle(f"Energy since $t$ = 0{shown}", fontsize=11)
    return figure


def _terms(run: xr.Dataset, labels: dict[str, str]) -> dict[str, Vector]:
    """Terms less their first values, by label [J/m]."""
    return {label: run[name].values - run[name].values[0] for name, label in labels.items()}


def _balance(axes: Axes, run: xr.Dataset, terms: dict[str, Vector]) -> None:
    axes.set_xlabel("time [s]")
    axes.set_ylabel("energy [MJ/m]")
    if said := stepless(run):
        said_in(axes, said)
        axes.set_xticks([])
        axes.set_yticks([])
        return
    time = run["time"].values
    for (label, values), color in zip(terms.items(), PALETTE, strict=False):
        axes.plot(time, values / 1e6, color=color, label=label)
    total = np.sum(list(terms.values()), axis=0)
    axes.plot(time, total / 1e6, "--", color="black", label="sum")
    axes.legend(fontsize=8, ncols=2, loc="upper center", bbox_to_anchor=(0.5, -0.18))


def _left_over(axes: Axes, runs: Sequence[xr.Dataset], labels: Sequence[str]) -> None:
    """|sum| of both balances over m g T."""
    for run, name, color in zip(runs, labels, PALETTE, strict=False):
        if said := stepless(run):
            axes.plot([], [], " ", label=f"{name}: {said}")
            continue
        config = json.loads(run.attrs["config"])
        weight = float(run["ship_mass"]) * config["water"]["gravity"] * config["hull"]["draft"]
        alone = np.sum(list(_terms(run, _SHIP).values()), axis=0)
        for values, style, label in (
            (run["energy_residual"].values, "-", name),
            (alone, ":", None),
        ):
            share = np.abs(values[1:]) / weight
            axes.semilogy(run["time"][1:], share, style, color=color, label=label)
    if all(map(stepless, runs)):
        axes.set_xticks([])
        axes.set_yticks([])
    axes.set_xlabel("time [s]")
    axes.set_ylabel("|sum| over $mgT$ [-]")
    axes.set_title(
        "what is left over: solid, ship, water and ends; dotted, the ship alone", fontsize=10
    )
    columns = 2 if max(map(len, labels)) < _WIDE else 1
    axes.legend(fontsize=8, ncols=columns, loc="upper center", bbox_to_anchor=(0.5, -0.18))


def _settings(run: xr.Dataset) -> str:
    model = "" if run.attrs["model"] == "full" else f", {run.attrs['model']}"
    return f"{run.attrs['force']} force, {run.attrs['coupling']}{model}"
