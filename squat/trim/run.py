"""Task `trim`: equilibria, stiffness, folds and limits of heave and pitch, and of heave alone."""

import logging
import math
from dataclasses import replace
from typing import Any

import numpy as np
import xarray as xr
from scipy.optimize import brentq

from squat.channel import AnyHull, stretched
from squat.dynamics.lagrangian import Lagrangian
from squat.errors import InputError
from squat.fluid.energy import ShipEnergy, still_water
from squat.fluid.ship import about_gravity, center_of_gravity, check_stability, rigid_body
from squat.mesh import Mesh, MeshSize, PositionError, submesh
from squat.mesh.generate import generate
from squat.quantities import Vector
from squat.records import build
from squat.records.trim_kinds import TRIM
from squat.reduced.greedy import reduce
from squat.stability.equilibria import OneDimensionalModel
from squat.trim.barrier import Barrier, ridge
from squat.trim.case import TrimCase
from squat.trim.equilibria import Modes, Point, branch, fold
from squat.trim.region import Region
from squat.trim.release import lost_speed
from squat.trim.summary import summary

_log = logging.getLogger(__name__)
MODES = ("heave", "pitch")
ESTIMATED = ("squat_speed", "safe_speed", "heave_only_limit")
"""Numbers with an error from coarser meshes."""
_FURTHER = 1.25
_REST = 1e-3
"""Force over the greatest stiffness [m] up to which a place counts as an equilibrium."""


def run(case: TrimCase) -> xr.Dataset:
    """Dataset of kind `trim`."""
    hull = stretched(case.hull, case.displacement)
    case = _within_reach(case, hull)
    ship, mesh = _ship(case, hull, case.mesh)
    region = _region(case, mesh)
    modes = Modes(ship.at_current, ship.lengths)
    points = _from_rest(case, modes)
    limit = _fold(case, modes, points)
    one = OneDimensionalModel(hull, case.channel, case.water).squat_speed()
    limits = _limits(case, ship, region, limit)
    data = {
        **_branch(modes, points),
        **_trimmed(modes, case, limits),
        "length": hull.length,
        "displacement": hull.outline.area,
        "squat_speed_1d": one.speed,
        "squat_sinkage_1d": one.sinkage,
        "squat_speed": limit.current,
        "squat_sinkage": limit.position[0],
        "squat_trim": limit.position[1],
        **limits,
    }
    data |= _errors(case, hull, data)
    return build(TRIM, data, {"summary": summary(case, data)})


def _from_rest(case: TrimCase, modes: Modes) -> list[Point]:
    toward = np.array([0.0, 0.0, 1.0])
    return branch(modes, np.zeros(2), 0.0, toward, case.step, case.points)


def _fold(case: TrimCase, modes: Modes, points: list[Point]) -> Point:
    """Fold within two steps of the branch's greatest current; InputError where there is none."""
    near = max(points, key=lambda point: point.current)
    found = fold(modes, near)
    apart = np.linalg.norm((found.position - near.position) * modes.lengths)
    if not (found.current >= near.current and apart < 2 * case.step):
        raise InputError(f"arc={case.arc:g}: no fold near the branch's greatest current; give less")
    return found


def _errors(case: TrimCase, hull: AnyHull, found: dict[str, Any]) -> dict[str, float]:
    """Estimated errors of `ESTIMATED`; NaN where the coarser meshes hold no answer."""
    coarser = [_on(case, hull, size) for size in case.companions.sizes(case.mesh)]
    values = np.array([*coarser, [found[name] for name in ESTIMATED]], float)
    names = [f"{name}_error" for name in ESTIMATED]
    return dict(zip(names, case.companions.error(values).tolist(), strict=True))


def _on(case: TrimCase, hull: AnyHull, size: MeshSize) -> list[float]:
    """`ESTIMATED` on another mesh, all found there anew; NaN where it is too coarse for a fold."""
    try:
        ship, mesh = _ship(case, hull, size)
        region, start = _region(case, mesh), _start(case)
        modes = Modes(ship.at_current, ship.lengths)
        limit = _fold(case, modes, _from_rest(case, modes)).current
        safe = Barrier(ship.at_current, region, start).safe_speed(limit)
        return [limit, safe, _heave_alone(ship, region, start, limit)]
    except (PositionError, InputError):
        return [math.nan] * len(ESTIMATED)


def _start(case: TrimCase) -> Vector:
    return np.array([case.start.heave, case.start.pitch])


def _within_reach(case: TrimCase, hull: AnyHull) -> TrimCase:
    """`case` with no more pitch in the box of its reduced model than hull and channel admit."""
    size = case.reduced.box
    coarse = submesh(hull, case.channel, MODES)
    coarse = coarse.about(center_of_gravity(coarse, hull))
    least = size.clearance * coarse.limits.clearance
    pitch = Region(coarse, size.pitch, least).greatest_pitch()
    if pitch < size.pitch:
        _log.debug(
            "reduced.box.pitch=%g: lowered to %.4g rad, all that hull and channel admit",
            size.pitch,
            pitch,
        )
    box = replace(size, pitch=pitch)
    return replace(case, reduced=replace(case.reduced, box=box))


def _ship(case: TrimCase, hull: AnyHull, size: MeshSize) -> tuple[ShipEnergy, Mesh]:
    coarse = submesh(hull, case.channel, MODES)
    mesh = about_gravity(generate(coarse, size), hull)
    body = rigid_body(hull, case.water, MODES)
    check_stability(mesh.submesh, body, case.water)
    made = reduce(mesh, case.water.density, "rigid_lid", case.reduced)
    return ShipEnergy(body, still_water(mesh.submesh, case.water), made.model, 0.0), mesh


def _region(case: TrimCase, mesh: Mesh) -> Region:
    least = max(case.grounding, 1.01 * case.reduced.box.clearance)
    box = case.reduced.box.pitch
    return Region(mesh.submesh, 0.98 * box, least * mesh.submesh.limits.clearance)


def _branch(modes: Modes, points: list[Point]) -> dict[str, Any]:
    stiffness = [
        modes.jacobian(p.position * modes.lengths, p.current**2 / 2)[:, :-1] for p in points
    ]
    return {
        "current": [p.current for p in points],
        "heave": [p.position[0] for p in points],
        "pitch": [p.position[1] for p in points],
        "unstable": [p.unstable for p in points],
        "heave_stiffness": [U2[0, 0] for U2 in stiffness],
        "pitch_stiffness": [U2[1, 1] * modes.lengths[1] ** 2 for U2 in stiffness],
    }


def _trimmed(modes: Modes, case: TrimCase, limits: dict[str, Any]) -> dict[str, Any]:
    """Branch through the lowest pass, both ways, as far as V^2 >= 0; none from no equilibrium."""
    x = np.array([limits["saddle_heave"], limits["saddle_pitch"]]) * modes.lengths
    strength = limits["safe_speed"] ** 2 / 2
    ways = [
        branch(modes, x, strength, sign * np.array([0.0, 0.0, 1.0]), case.step, case.points)
        for sign in (-1, 1)
        if np.linalg.norm(modes.gradient(x, strength)) < _REST * abs(modes.jacobian(x, 0.0)).max()
    ]
    both = [*ways[0][:0:-1], *ways[1]] if ways else []
    points = [point for point in both if math.isfinite(point.current)]
    return {
        "trimmed_current": [p.current for p in points],
        "trimmed_heave": [p.position[0] for p in points],
        "trimmed_pitch": [p.position[1] for p in points],
        "trimmed_unstable": np.array([p.unstable for p in points], int),
    }


def _limits(case: TrimCase, ship: ShipEnergy, region: Region, limit: Point) -> dict[str, Any]:
    start = _start(case)
    barrier = Barrier(ship.at_current, region, start)
    safe = barrier.safe_speed(limit.current)
    saddle = barrier.lowest(safe)
    alone = _heave_alone(ship, region, start, limit.current)
    period = 2 * math.pi / math.sqrt(_stiffness(ship) / ship.mass(np.zeros(2))[0, 0])
    grid = period / case.steps_per_period, round(case.periods * case.steps_per_period)
    ends = safe, limit.current
    lost, kept = lost_speed(
        ship.at_current, region, start, ship.lengths, grid, ends, case.tolerance
    )
    return {
        "heave_only_limit": alone,
        "safe_speed": safe,
        "saddle_heave": saddle.heave,
        "saddle_pitch": saddle.pitch,
        "dynamic_limit": lost,
        "dynamic_limit_error": case.tolerance / 2,
        "greatest_trim": float(np.abs(kept.position[:, 1]).max()),
        "drift": kept.drift / (ship.body.mass * ship.body.gravity * case.hull.draft),
        "start_heave": start[0],
        "start_pitch": start[1],
    }


def _stiffness(ship: ShipEnergy) -> float:
    return float(ship.hydrostatics.stiffness[0, 0])


def _heave_alone(ship: ShipEnergy, region: Region, start: Vector, guess: float) -> float:
    """Dynamic limit [m/s] with the pitch locked at the start's: exact, from the same energies.

    Over an uneven bottom it may lie far beyond the fold of a ship that is free to trim, `guess`.
    """

    def lack(V: float) -> float:
        system: Lagrangian = ship.at_current(V)
        return ridge(system, region, float(start[1])).potential - system.potential(start)

    fastest = guess
    while lack(fastest) >= 0:  # ends: U falls with V^2, most where the gap is least
        fastest *= _FURTHER
    return float(brentq(lack, 0.0, fastest))
