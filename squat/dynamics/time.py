"""Time grids measured in periods of the linear oscillation."""

import math

from pydantic.dataclasses import dataclass

from squat.quantities import STRICT, Count, Positive


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

    def step(self, omega: float) -> float:
        """Time step dt [s] for the angular frequency `omega` [rad/s]."""
        return 2 * math.pi / omega / self.steps_per_period

    @property
    def steps(self) -> int:
        """Number of time steps in the run."""
        return max(1, round(self.periods * self.steps_per_period))
