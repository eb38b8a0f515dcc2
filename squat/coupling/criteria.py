"""When a time step's iteration ends, well or badly."""

import math
from typing import Literal

import numpy as np
from pydantic.dataclasses import dataclass

from squat.quantities import STRICT, Count, Positive, Vector


@dataclass(frozen=True, kw_only=True, config=STRICT)
class Criterion:
    """|q^{k+1} - q^k| < tolerance, divided by |q^{k+1}| where relative (Algorithm 1, line 10).

    Parameters
    ----------
    name
        `absolute` (tolerance in metres) or `relative` (a fraction).
    tolerance
        Bound on the residual's norm.
    iterations
        Iteration limit of one time step.
    growth
        The step has diverged once the residual is not finite or this many times its first.
    """

    name: Literal["absolute", "relative"]
    tolerance: Positive
    iterations: Count
    growth: Positive

    def met(self, residual: float, position: Vector) -> bool:
        """Whether `residual` [m] is small enough at `position` (shape (n,))."""
        scale = 1.0 if self.name == "absolute" else float(np.linalg.norm(position))
        return residual < self.tolerance * scale or residual == 0.0

    def lost(self, residual: float, first: float) -> bool:
        """Whether `residual` says that the iteration diverges; `first` was the step's first."""
        return not (
            math.isfinite(residual) and residual <= self.growth * max(first, self.tolerance)
        )
