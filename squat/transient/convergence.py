"""Task `convergence`: the headline numbers on three meshes and with three time steps.

Each with its observed order, its extrapolated value and its grid convergence index: P. J. Roache,
J. Fluids Eng. 116 (1994) 405, in the form of I. B. Celik and others, J. Fluids Eng. 130 (2008)
078001, with the factor of three meshes, 1.25.
"""

import math
from collections.abc import Iterator
from dataclasses import replace
from typing import Annotated, NamedTuple

import numpy as np
import xarray as xr
from pydantic import Field
from pydantic.dataclasses import dataclass
from scipy.interpolate import CubicSpline

from squat.errors import InputError
from squat.fluid.accuracy import LEVELS, extrapolate, observed_order
from squat.fluid.added_mass import AddedMass
from squat.mesh import submesh
from squat.mesh.generate import generate
from squat.progress import progress
from squat.quantities import STRICT, Speed, Vector
from squat.records import build
from squat.records.stability_kinds import CONVERGENCE
from squat.stability.case import Start
from squat.stability.dynamic import dynamic_squat_speed
from squat.stability.fold import squat_speed
from squat.stability.heave import HeaveSystem
from squat.stability.orbits import orbit
from squat.stability.portrait import highest_pair
from squat.stability.sampling import Ship, Surface
from squat.transient.case import TransientCase
from squat.transient.options import CouplingChoice
from squat.transient.run import run as transient

_HEAVE = 1
_MESH, _STEP = "mesh", "time step"


@dataclass(frozen=True, kw_only=True, config=STRICT)
class ConvergenceCase(TransientCase):
    """A coupled run, and what else is asked about its ship.

    Its own mesh and `current` are those of the runs whose time step is refined.

    Parameters
    ----------
    currents
        Speeds at which equilibria and motion are wanted on three meshes [m/s].
    beside
        A second coupling whose time step is refined.
    """

    free_surface: Surface
    currents: Annotated[tuple[Speed, ...], Field(min_length=1)]
    beside: CouplingChoice

    def __post_init__(self) -> None:
        super().__post_init__()
        if self.time.until != "turn":
            raise InputError(f"time.until={self.time.until}: give turn, where runs are compared")
        if tuple(self.modes) != ("heave",):
            raise InputError(f"modes={list(self.modes)}: give modes=[heave]")


class Quantity(NamedTuple):
    """A headline number: name, current [m/s] or NaN, unit, what is refined, its three values."""

    name: str
    current: float
    unit: str
    refined: str
    levels: Vector


def run(case: ConvergenceCase) -> xr.Dataset:
    """Dataset of kind `convergence`."""
    found = [*_on_meshes(case), *_with_steps(case)]
    levels: list[Vector] = list(np.array([one.levels for one in found]).T)
    ratio = float(case.accuracy.refinement)
    value, error = extrapolate(levels, ratio, case.accuracy.safety)
    data = {
        "quantity": [one.name for one in found],
        "current": [one.current for one in found],
        "unit": [one.unit for one in found],
        "refined": [one.refined for one in found],
        "level_value": np.transpose(levels),
        "observed_order": observed_order(levels, ratio),
        "value": value,
        "error": error,
    }
    return build(CONVERGENCE, data, {"refinement": ratio, "safety": case.accuracy.safety})


def _on_meshes(case: ConvergenceCase) -> Iterator[Quantity]:
    """Added mass, limits, equilibria and periods on three graded P2 meshes."""
    ship = Ship(case.hull, case.channel, case.water, case.free_surface, case.grounding)
    levels = ship.levels(case.accuracy)
    start = Start(heave=case.initial_heave, velocity=0.0)
    start.check(levels[0].interval)
    yield from _inertia(case, levels)
    rows = [list(_energies(level, start, case.currents)) for level in levels]
    for same in zip(*rows, strict=True):
        (name, current, unit, _), *_ = same
        yield Quantity(name, current, unit, _MESH, np.array([value for *_, value in same]))


def _inertia(case: ConvergenceCase, levels: list[HeaveSystem]) -> Iterator[Quantity]:
    coarse = submesh(case.hull, case.channel)
    sizes = [case.accuracy.size(case.hull, case.channel, level) for level in range(LEVELS)]
    open_water = [
        AddedMass(generate(coarse, size), "zero_pressure").matrix[_HEAVE, _HEAVE] for size in sizes
    ]
    area = case.hull.outline.area
    for name, ratios in (
        ("added mass over ship mass, zero pressure", np.array(open_water) / area),
        ("water's inertia over ship mass", np.array([_share(level) for level in levels])),
    ):
        yield Quantity(name, math.nan, "1", _MESH, ratios)


def _share(system: HeaveSystem) -> float:
    """c(0)/m."""
    return float(system.inertia(0.0)) / system.ship_mass


def _energies(
    ship: HeaveSystem, start: Start, currents: tuple[float, ...]
) -> Iterator[tuple[str, float, str, float]]:
    """Name, current, unit and value of what the energies on one mesh imply."""
    fold = squat_speed(ship.at_current)
    limit = dynamic_squat_speed(ship.at_current, fold, start.heave, start.velocity)
    yield "2D squat speed", math.nan, "m s-1", fold.speed
    yield "dynamic squat speed", math.nan, "m s-1", limit
    for current in currents:
        mode = ship.at_current(current)
        stable, unstable = highest_pair(mode)
        free = orbit(mode, start.heave, start.velocity)
        yield "stable equilibrium", current, "m", stable
        yield "unstable equilibrium", current, "m", unstable
        yield "lowest heave", current, "m", free.low
        yield "period", current, "s", free.period


def _with_steps(case: ConvergenceCase) -> Iterator[Quantity]:
    """First turning point of coupled runs on one mesh, with time steps refined."""
    works = [
        (coupling, case.time.steps_per_period * case.accuracy.refinement**level)
        for coupling in (case.coupling, case.beside)
        for level in range(LEVELS)
    ]
    turns = [
        _turn(replace(case, coupling=coupling, time=replace(case.time, steps_per_period=steps)))
        for coupling, steps in progress(iter(works), len(works), "time steps refined")
    ]
    for number, coupling in enumerate((case.coupling, case.beside)):
        own = np.array(turns[number * LEVELS : (number + 1) * LEVELS])
        name = f"first turning point, {coupling.name}"
        yield Quantity(f"{name}: heave", case.current, "m", _STEP, own[:, 0])
        yield Quantity(f"{name}: time", case.current, "s", _STEP, own[:, 1])


def _turn(case: TransientCase) -> tuple[float, float]:
    """Heave [m] and time [s] of a run's first turning point, between its steps; NaN without one."""
    data = transient(case).dataset
    if data.attrs["status"] != "turned":
        return math.nan, math.nan
    heave = CubicSpline(data["time"].values, data["heave"].values)
    last = float(data["time"][-3])
    times = heave.derivative().roots(extrapolate=False)
    time = float(times[times >= last][0])
    return float(heave(time)), time
