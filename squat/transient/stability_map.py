"""Stability map: the fate of ships released at rest, over current and initial heave."""

from collections import deque
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from typing import Annotated, Literal

import numpy as np
import xarray as xr
from numpy.typing import NDArray
from pydantic import Field
from pydantic.dataclasses import dataclass

from squat.channel import AnyHull, Channel
from squat.dynamics.hydrostatics import heave_stiffness
from squat.errors import InputError
from squat.fluid.curves import Curves
from squat.fluid.ship import LOADING
from squat.mesh import MeshSize
from squat.mesh.motion import Index
from squat.progress import progress
from squat.quantities import STRICT, Count, Fraction, Position, Positive, Speed, Vector
from squat.records import build, read_input
from squat.records.fleet_kinds import STABILITY_MAP
from squat.records.reduced_kinds import REDUCED
from squat.reduced.case import MeshInput, ReducedCase
from squat.reduced.greedy import Training
from squat.reduced.record import Loaded, load, on_patch
from squat.reduced.run import make
from squat.stability.fold import squat_speed
from squat.stability.heave import HeaveSystem
from squat.stability.one_mode import Interval
from squat.stability.separatrix import separatrix
from squat.transient.fleet import GROUNDED, UNDECIDED, Fates, Fleet
from squat.water import Water

Mask = NDArray[np.bool_]
_POINTS = 24
"""Positions that the curves are made from."""
_TOWARDS_FOLD = 1 - np.linspace(1, 1e-3, 80) ** 2
"""Currents over the fold's at which the edge is drawn: evenly in the root that it closes with."""
_INSIDE = 1e-9
"""Share of the curves' range kept clear of their upper end."""


@dataclass(frozen=True, kw_only=True, config=STRICT)
class Currents:
    """Currents V of the map [m/s]: `points` of them, evenly from `least` to `greatest`."""

    least: Speed
    greatest: Speed
    points: Count


@dataclass(frozen=True, kw_only=True, config=STRICT)
class Heaves:
    """Initial heaves w(0) of the map [m]: `points` of them, evenly from `least` to `greatest`."""

    least: Position
    greatest: Position
    points: Count


@dataclass(frozen=True, kw_only=True, config=STRICT)
class MapInputs:
    """Files of earlier tasks; None: make what is lacking.

    Parameters
    ----------
    mesh
        Dataset of task=mesh for the same hull, channel and mesh.
    reduced
        Dataset of task=reduced for the same hull, channel, water, mesh and free surface.
    """

    mesh: str | None
    reduced: str | None


@dataclass(frozen=True, kw_only=True, config=STRICT)
class StabilityMapCase:
    """Ships released at rest at every pair of a current and an initial heave.

    Parameters
    ----------
    grounding
        Clearance over that at rest, below which a ship counts as grounded.
    steps_per_period
        Least number of time steps in a period of small heave in still water.
    periods
        Such periods after which a ship is undecided.
    """

    hull: AnyHull
    channel: Channel
    water: Water
    mesh: MeshSize
    free_surface: Literal["rigid_lid", "blend"]
    reduced: Training
    currents: Currents
    heaves: Heaves
    grounding: Fraction
    steps_per_period: Annotated[int, Field(strict=True, ge=20)]
    periods: Positive
    inputs: MapInputs


def run(case: StabilityMapCase) -> xr.Dataset:
    """Dataset of kind `stability_map`."""
    loaded = _reduced(case)
    clearance = loaded.model.submesh.limits.clearance
    low, high = loaded.model.box.bounds
    curves = Curves.of(loaded.fluid(case.water, 0.0), low - clearance, high - clearance, _POINTS)
    lowest = (case.grounding - 1) * clearance
    fleet = _fleet(case, curves, lowest)
    heave, current = _axis(case.heaves), _axis(case.currents)
    if not (lowest < heave.min() and heave.max() < fleet.highest):
        raise InputError(
            f"heaves.least={case.heaves.least:g} heaves.greatest={case.heaves.greatest:g}: "
            f"must lie between {lowest:.4g} and {fleet.highest:.4g} m"
        )
    fates = _march(case, fleet, heave, current)
    interval = Interval(lowest, curves.ends[1])
    system = replace(HeaveSystem.of(case.hull, case.water, curves), interval=interval)
    loops = _loops(system, current)
    towards_fold = squat_speed(system.at_current).speed * _TOWARDS_FOLD
    edge = _loops(system, towards_fold)
    expected = _inside(loops, heave)
    grounded = fates["outcome"] == GROUNDED
    decided = fates["outcome"] != UNDECIDED
    apart = int((decided & (grounded == expected)).sum())
    data = {
        "initial_heave": heave,
        "current": current,
        "time_to_grounding": np.where(grounded, fates.pop("time"), np.nan),
        **fates,
        "expected_safe": expected.astype(np.int8),
        "barrier": loops[0],
        "turn": loops[1],
        "edge_current": towards_fold,
        "edge_barrier": edge[0],
        "edge_turn": edge[1],
    }
    return build(
        STABILITY_MAP,
        data,
        {"disagreements": apart, "undecided": int((~decided).sum()), "grounding_heave": lowest},
    )


def _reduced(case: StabilityMapCase) -> Loaded:
    if case.inputs.reduced is not None:
        same = ("hull", "channel", "water", "mesh", "free_surface")
        read_input(case.inputs.reduced, REDUCED, case, same, ignoring=LOADING)
        return load(Path(case.inputs.reduced))
    made = make(
        ReducedCase(
            hull=case.hull,
            channel=case.channel,
            water=case.water,
            mesh=case.mesh,
            free_surface=case.free_surface,
            reduced=case.reduced,
            fields=False,
            inputs=MeshInput(mesh=case.inputs.mesh),
        )
    )
    return on_patch(*made)


def _axis(given: Currents | Heaves) -> Vector:
    return np.linspace(given.least, given.greatest, given.points)


def _fleet(case: StabilityMapCase, curves: Curves, lowest: float) -> Fleet:
    outline, rho = case.hull.outline, case.water.density
    low, high = curves.ends
    return Fleet(
        curves,
        rho * outline.area,
        heave_stiffness(case.water, outline.length),
        rho * outline.length,
        lowest,
        high - _INSIDE * (high - low),
    )


def _march(
    case: StabilityMapCase, fleet: Fleet, heave: Vector, current: Vector
) -> dict[str, Vector]:
    """What became of the ship at each point, shape (initial_heave, current)."""
    w, V = (grid.ravel() for grid in np.meshgrid(heave, current, indexing="ij"))
    inertia = fleet.mass + fleet.water(np.zeros(1))[1, 0]
    period = 2 * np.pi * np.sqrt(inertia / fleet.stiffness)
    dt, end = period / case.steps_per_period, case.periods * period
    rows = np.zeros((4, len(w)))
    deque(progress(_one_by_one(fleet.march(w, V, dt, end), rows), len(w), "ships"), maxlen=0)
    names = ("outcome", "time", "least_clearance", "energy_gain")
    shape = len(heave), len(current)
    found = {name: row.reshape(shape) for name, row in zip(names, rows, strict=True)}
    found["outcome"] = found["outcome"].astype(np.int8)
    return found


def _one_by_one(ended: Iterator[tuple[Index, Fates]], rows: Vector) -> Iterator[int]:
    """Writes fates into `rows` (4, ships) as they come; yields the number of every ship."""
    for numbers, fates in ended:
        rows[:, numbers] = fates
        yield from numbers.tolist()


def _loops(system: HeaveSystem, current: Vector) -> Vector:
    """Least and greatest safe initial heave at each current by energy alone, shape (2, current)."""
    found = [separatrix(system.at_current(V), 2).heave for V in current.tolist()]
    return np.array(found).T


def _inside(loops: Vector, heave: Vector) -> Mask:
    """Where a release is safe by the separatrix; a loop without top reaches the interval's end."""
    low, high = loops
    return np.asarray((heave[:, None] > low) & ~(heave[:, None] >= high))
