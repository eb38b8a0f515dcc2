"""Time grids measured in periods of the linear oscillation."""

import math

from pydantic.dataclasses import dataclass

from squat.errors import InputError
from squat.quantities import STRICT, Count, Positive

MOST_STEPS = 10**7
"""Time steps of the longest run whose history fits into memory."""


@dataclass(frozen=True, kw_only=True, config=STRICT)
class TimeGrid:
    """Uniform time steps (Table 1 and section 3.6).

    Parameters
    ----------
    periods
        Length of the run in periods 2 pi / omega.
    steps_per_period
        N: time steps in a period.
    """

    periods: Positive
    steps_per_period: Count

    def __post_init__(self) -> None:
        if self.periods * self.steps_per_period > MOST_STEPS:
            raise InputError(
                f"time.periods={self.periods:g}: with time.steps_per_period="
                f"{self.steps_per_period} more than {MOST_STEPS} time steps; lower one of them"
            )

    def step(self, omega: float) -> float:
        """Time step dt [s] for the angular frequency `omega` [rad/s]."""
        return 2 * math.pi / omega / self.steps_per_period

    @property
    def steps(self) -> int:
        """Number of time steps in the run."""
        return max(1, round(self.periods * self.steps_per_period))
