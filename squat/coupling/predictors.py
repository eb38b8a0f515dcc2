"""The motion that a time step starts its iteration from."""

from collections.abc import Callable, Sequence
from typing import Literal

from squat.dynamics import Kinematics, Motion
from squat.dynamics.integrators import positions

PredictorName = Literal["hold", "linear", "quadratic"]
Predictor = Callable[[Sequence[Motion], Kinematics], Motion]


def hold(past: Sequence[Motion], kinematics: Kinematics) -> Motion:
    """w^0 = w^n with its velocity and acceleration (Algorithm 1, line 3)."""
    return past[0]


def linear(past: Sequence[Motion], kinematics: Kinematics) -> Motion:
    """q^0 = 2 q^n - q^{n-1}, tied by the integrator; `hold` at the first step."""
    if len(past) < 2:
        return past[0]
    return kinematics.at_position(2 * past[0].position - past[1].position)


def quadratic(past: Sequence[Motion], kinematics: Kinematics) -> Motion:
    """q^0 = 3 q^n - 3 q^{n-1} + q^{n-2}, tied by the integrator.

    Levels before the start lie on the parabola of its velocity and acceleration.
    """
    q0, q1, q2 = positions(past, kinematics.dt, 3)
    return kinematics.at_position(3 * (q0 - q1) + q2)


PREDICTORS: dict[PredictorName, Predictor] = {
    "hold": hold,
    "linear": linear,
    "quadratic": quadratic,
}
LEVELS = 3
"""Past levels that the longest predictor looks at."""
