"""Curves over time, of one run or overlaid, and their differences.

A plot is an entry of `PLOTS`; it appears where a record holds the variables that it needs.
"""

from collections.abc import Callable
from typing import NamedTuple

import numpy as np
import rerun.blueprint as rrb
import xarray as xr

from squat.replay.panels import Place
from squat.replay.style import GREEN, ORANGE, PURPLE, RED, SKY, YELLOW

Values = Callable[[xr.Dataset], xr.DataArray]


class Curve(NamedTuple):
    """One line: entity, values (time,) or () of a record, name in the legend, colour.

    `compared` curves are overlaid where there are several runs, and their differences drawn; a
    `width` [points] beyond the others' shows a curve below one that it should agree with. Several
    runs have a constant that they share; one that is of a run's `last` moment is a dot there. A
    `bound` is left out where it lies so far from what moves that it would flatten that.
    `whole` numbers belong to steps, and are not interpolated between them.
    """

    name: str
    values: Values
    label: str
    color: str
    compared: bool = False
    width: float = 1.5
    last: bool = False
    bound: bool = False
    whole: bool = False


class Plot(NamedTuple):
    """One diagram over time: entity, title with unit, variables, lines.

    `title` for a single run, `several` for more, where it has to tell which curves are compared.
    `least_span` of the vertical axis keeps rounding from filling the diagram. Differences of a
    plot that stands elsewhere than in `Place.PLOT` stand beside it. The axis reaches down to
    `base`, if there is one.
    """

    name: str
    title: str
    needs: tuple[str, ...]
    curves: tuple[Curve, ...]
    legend: rrb.Corner2D = rrb.Corner2D.RightTop
    least_span: float = 0.0
    place: Place = Place.PLOT
    several: str = ""
    base: float | None = None


def variable(name: str) -> Values:
    """The variable itself."""
    return lambda data: data[name]


def counts(data: xr.Dataset) -> xr.DataArray:
    """Iterations of the steps taken: the start takes none."""
    return data["iterations"].where(data["iterations"] > 0)


def since_start(*names: str) -> Values:
    """Change of the sum of `names` since the start, in millions."""
    return lambda data: sum(data[name] - data[name][0] for name in names) / 1e6  # type: ignore[return-value]


def degrees(name: str) -> Values:
    """An angle of the record in degrees."""
    return lambda data: data[name] * (180 / np.pi)


def error(data: xr.Dataset) -> xr.DataArray:
    """Distance of the piston from its exact position."""
    return data["position"] - data["exact_position"]


def failed_contraction(data: xr.Dataset) -> xr.DataArray:
    """Contraction of the step that did not converge, where the record tells it."""
    return data.get("failed_contraction", xr.DataArray(np.nan))


_ROOTS = ("stable root of (27), a box", "unstable root of (27), a box")
_WATER = ("water_energy", "static_energy", "stream_energy")
PLOTS = (
    Plot(
        "heave",
        "Heave w [m]",
        ("heave", "stable_root", "unstable_root"),
        (
            Curve("heave", variable("heave"), "w", SKY, compared=True),
            Curve("stable_root", variable("stable_root"), _ROOTS[0], GREEN, True, 0.75),
            Curve(
                "unstable_root", variable("unstable_root"), _ROOTS[1], RED, True, 0.75, bound=True
            ),
        ),
        rrb.Corner2D.LeftBottom,
    ),
    Plot(
        "pitch",
        "Pitch, bow down [°]",
        ("pitch", "pitch_moment"),
        (Curve("pitch", degrees("pitch"), "pitch", ORANGE, compared=True),),
    ),
    Plot(
        "position",
        "Position w [m]",
        ("position", "exact_position"),
        (
            Curve("exact_position", variable("exact_position"), "exact, Eq. (5)", ORANGE, width=4),
            Curve("position", variable("position"), "w", SKY, compared=True),
        ),
    ),
    Plot(
        "error",
        "Error of the position [m]",
        ("position", "exact_position"),
        (Curve("error", error, "w less exact", PURPLE, compared=True),),
    ),
    Plot(
        "iterations",
        "Iterations of a step",
        ("iterations",),
        (Curve("iterations", counts, "iterations", SKY, compared=True, whole=True),),
        base=0.0,
    ),
    Plot(
        "ship_energies",
        "Balance of the ship alone, Fig. 13, since start [MJ/m]",
        ("kinetic_energy", "potential_energy", "fluid_work"),
        (
            Curve("kinetic", since_start("kinetic_energy"), "E_c", RED, compared=True),
            Curve("potential", since_start("potential_energy"), "E_p", SKY),
            Curve("work", since_start("fluid_work"), "W", GREEN),
            Curve(
                "sum",
                since_start("kinetic_energy", "potential_energy", "fluid_work"),
                "sum",
                PURPLE,
            ),
        ),
        place=Place.ENERGY,
    ),
    Plot(
        "energy_audit",
        "Balance of ship, water and ends since start [MJ/m]",
        ("kinetic_energy", *_WATER, "end_work", "energy_residual"),
        (
            Curve("ship", since_start("kinetic_energy"), "ship m w'^2/2", RED),
            Curve("water", since_start("water_energy"), "water T_f", SKY),
            Curve("static", since_start("static_energy"), "still water and weight", GREEN),
            Curve("stream", since_start("stream_energy"), "stream's head U_B", YELLOW),
            Curve("ends", lambda data: -data["end_work"] / 1e6, "minus work of the ends", ORANGE),
            Curve("sum", lambda data: data["energy_residual"] / 1e6, "sum", PURPLE, compared=True),
        ),
        place=Place.ENERGY,
    ),
    Plot(
        "piston_energies",
        "Energies of all [J]",
        ("kinetic_energy", "potential_energy", "exact_position"),
        (
            Curve("kinetic", variable("kinetic_energy"), "kinetic", RED, compared=True),
            Curve("potential", variable("potential_energy"), "potential", SKY),
            Curve(
                "sum",
                lambda data: data["kinetic_energy"] + data["potential_energy"],
                "sum",
                PURPLE,
                compared=True,
            ),
        ),
    ),
    Plot(
        "contraction",
        "Contraction factor",
        ("contraction", "predicted_contraction"),
        (
            Curve("expected", variable("predicted_contraction"), "predicted G", ORANGE, width=4),
            Curve(
                "failed_step", failed_contraction, "failed step", RED, True, last=True, bound=True
            ),
            Curve("measured", variable("contraction"), "measured", SKY, compared=True),
        ),
        least_span=0.02,
        several="Contraction factor, measured",
    ),
)
