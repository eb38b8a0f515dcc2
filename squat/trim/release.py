"""Set free and watched: the current that loses a ship, by bisection on energy-keeping runs."""

import math
from typing import NamedTuple

import numpy as np

from squat.dynamics.energy_momentum import Phase, advance
from squat.dynamics.lagrangian import Lagrangian, energy
from squat.mesh import PositionError
from squat.progress import progress
from squat.quantities import Vector
from squat.trim.equilibria import Family
from squat.trim.region import Region


class Track(NamedTuple):
    """A run: positions (steps + 1, n), greatest change of the energy [J/m], whether it was lost."""

    position: Vector
    drift: float
    lost: bool


def release(
    system: Lagrangian, region: Region, start: Vector, lengths: Vector, dt: float, steps: int
) -> Track:
    """At most `steps` steps of `dt` [s] from rest at `start` (n,), until the ship is lost."""
    phase, path, drift = Phase(start, np.zeros_like(start)), [start], 0.0
    first = system.potential(start)
    try:
        for _ in range(steps):
            step = advance(system, phase, dt, lengths)
            if step.outcome != "converged":
                return Track(np.array(path), drift, True)
            phase = step.phase
            path.append(phase.position)
            q, P = phase
            velocity = np.asarray(np.linalg.solve(system.mass(q), P), float)
            drift = max(drift, abs(energy(system, q, velocity) - first))
            heave, pitch = q
            if abs(pitch) >= region.pitch or heave <= region.low(pitch):
                return Track(np.array(path), drift, True)
    except PositionError:
        return Track(np.array(path), drift, True)
    return Track(np.array(path), drift, False)


def lost_speed(
    family: Family,
    region: Region,
    start: Vector,
    lengths: Vector,
    grid: tuple[float, int],
    ends: tuple[float, float],
    tolerance: float,
) -> tuple[float, Track]:
    """Least current [m/s] that loses the ship within the run, and the fastest run that is kept.

    Parameters
    ----------
    grid
        Time step [s] and number of steps.
    ends
        A current that keeps the ship, and one that is thought to lose it.
    tolerance
        Of the current [m/s].

    Notes
    -----
    Bisection finds one edge between safe and lost currents; where windows of safe currents lie
    above it, others exist. NaN where the upper end keeps the ship too.
    """
    low, high = ends
    last = release(family(high), region, start, lengths, *grid)
    if not last.lost:
        return float("nan"), last
    kept = None
    halvings = math.ceil(math.log2(max((high - low) / tolerance, 1.0)))
    for _ in progress(range(halvings), halvings, "runs set free, bisection of the current"):
        middle = (low + high) / 2
        track = release(family(middle), region, start, lengths, *grid)
        low, high = (low, middle) if track.lost else (middle, high)
        kept = kept if track.lost else track
    return (low + high) / 2, kept or release(family(low), region, start, lengths, *grid)
