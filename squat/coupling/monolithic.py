"""Both equations of a step as one: the reference that every iteration must reach."""

from typing import Any, Literal

import numpy as np
import scipy  # its parts load on use: slow, and few commands need them
from pydantic.dataclasses import dataclass

from squat.coupling.problem import Load, Problem
from squat.dynamics import Kinematics, Motion
from squat.quantities import STRICT, Vector

_DIFFERENCE = 1e-6
"""Step of the Jacobian's differences over the greater of 1 and |q|."""
_ROUND_OFF = 1e-15


@dataclass(frozen=True, kw_only=True, config=STRICT)
class Monolithic:
    """M q'' - F(q, q', q'') = 0 with q', q'' tied to q, by Newton's method to round-off.

    Takes the place of scheme and accelerator; needs no estimate of an added mass. The Jacobian is
    differenced through the force, so that n + 1 evaluations make one exact Newton step of a linear
    problem. Powell's hybrid method (MINPACK) safeguards the others.
    """

    name: Literal["monolithic"]


def together(
    problem: Problem, kinematics: Kinematics, guess: Motion, memory: Any
) -> tuple[Motion, Load, list[Vector]]:
    """Motion that solves the step's equations, its load, and all residuals met on the way.

    A residual, shape (n,), is dt^2/s3 M^-1 F - (dt^2/s3) q'' [m]: the standard scheme's change of
    position.
    """
    flexibility = kinematics.dt**2 / kinematics.s3 * np.linalg.inv(problem.mass)
    residuals: list[Vector] = []

    def residual(position: Vector) -> Vector:
        trial = kinematics.at_position(position)
        force = problem.load(trial, memory, kinematics.dt).force
        residuals.append(flexibility @ (force - problem.mass @ trial.acceleration))
        return residuals[-1]

    step = _DIFFERENCE * max(1.0, float(np.abs(guess.position).max()))

    def jacobian(position: Vector) -> Vector:
        return np.atleast_2d(scipy.optimize.approx_fprime(position, residual, step))

    found = scipy.optimize.root(residual, guess.position, jac=jacobian, tol=_ROUND_OFF)
    end = kinematics.at_position(np.asarray(found.x, float))
    residual(end.position)
    return end, problem.load(end, memory, kinematics.dt), residuals
