"""The added mass of a force that is known by its answers only."""

from typing import Any, NamedTuple

import numpy as np

from squat.coupling.problem import Problem
from squat.coupling.schemes import standard
from squat.dynamics import Kinematics, Motion
from squat.quantities import Vector


class Iterates(NamedTuple):
    """Trial accelerations and the forces that answered them, shape (k, n) each."""

    accelerations: Vector
    forces: Vector


def first_iterates(
    problem: Problem, kinematics: Kinematics, trial: Motion, memory: Any
) -> Iterates:
    """The first n + 1 iterates of a step from which n modes can be told apart.

    The trial itself, then for each mode the trial with that mode's acceleration changed as the
    standard scheme changes it: for n = 1 these are that scheme's first two iterates.
    """
    start = kinematics.at_position(trial.position)
    load = problem.load(start, memory, kinematics.dt)
    answer = standard(problem.mass).solve(load.force, start, kinematics)
    changes = _apart(answer.acceleration - start.acceleration, start.acceleration)
    accelerations, forces = [start.acceleration], [load.force]
    for change in np.diag(changes):
        moved = kinematics.at_acceleration(start.acceleration + change)
        accelerations.append(moved.acceleration)
        forces.append(problem.load(moved, memory, kinematics.dt).force)
    return Iterates(np.array(accelerations), np.array(forces))


def _apart(changes: Vector, accelerations: Vector) -> Vector:
    """`changes`, made large enough where they are too small to divide by, or no numbers."""
    changes = np.nan_to_num(changes, posinf=0.0, neginf=0.0)
    largest = float(np.abs(changes).max()) or float(np.abs(accelerations).max()) or 1.0
    return np.where(np.abs(changes) > 1e-3 * largest, changes, largest)


def effective_added_mass(iterates: Iterates) -> Vector:
    """-dF/dq'' of the iterates, shape (n, n): least squares, of least norm where undetermined.

    Position and velocity are tied to the acceleration, so that for F = -M_f q'' - C q' - K q this
    is M_f + (s1/s3) dt C + (dt^2/s3) K: all that an iteration feeds back. As m_add it makes G = 0.
    Exact where F is linear. It need not be symmetric. NaN where a force is not finite.
    """
    changes = np.diff(iterates.accelerations, axis=0)
    if not np.isfinite(iterates.forces).all():  # LAPACK would say so on the terminal, and raise
        return np.full((changes.shape[1],) * 2, np.nan)
    answers = np.diff(iterates.forces, axis=0)
    return np.asarray(-np.linalg.lstsq(changes, answers)[0].T, float)


def dominant_factor(mass: Vector, effective: Vector, added_mass: Vector) -> float:
    """Eigenvalue of greatest modulus of G = (M + m_add)^-1 (m_add - m_eff); modulus if complex.

    NaN where `effective` is not finite.
    """
    if not np.isfinite(effective).all():
        return np.nan
    values = np.linalg.eigvals(np.linalg.solve(mass + added_mass, added_mass - effective))
    value = values[np.argmax(np.abs(values))]
    return float(value.real) if value.imag == 0 else float(abs(value))
