"""Speeds at which a ship is looked at: those given, or shares of its own squat speed."""

import math
from typing import Annotated

import numpy as np
from pydantic import Field
from pydantic.dataclasses import dataclass

from squat.errors import InputError
from squat.quantities import STRICT, Count, NonNegative, Positive, Speed, Vector

_FINENESS = 0.02
"""Share of a scale that rounding may move a number by, twice over."""


@dataclass(frozen=True, kw_only=True, config=STRICT)
class Speeds:
    """Speeds at which equilibria are wanted.

    Parameters
    ----------
    least, greatest
        Ends of the curve over speed [m/s] (Table 6); no greatest: from its share.
    points
        Points of that curve.
    cases
        Single speeds [m/s] (Table 7); None: from their shares.
    greatest_share, case_shares
        The same over the ship's squat speed; what follows is rounded, see `readable`.
    """

    least: Speed
    greatest: Speed | None
    points: Count
    cases: Annotated[tuple[Speed, ...], Field(min_length=1)] | None
    greatest_share: Positive
    case_shares: Annotated[tuple[NonNegative, ...], Field(min_length=1)]

    def curve(self, squat_speed: float) -> Vector:
        """Evenly spaced speeds [m/s] of a ship of that squat speed, shape (points,)."""
        greatest = self.greatest
        if greatest is None:
            greatest = readable(self.greatest_share * squat_speed, squat_speed)
        if self.points > 1 and greatest <= self.least:
            raise InputError(
                f"speeds.least={self.least:g}: must be less than speeds.greatest={greatest:g}"
            )
        return np.linspace(self.least, greatest, self.points)

    def single(self, squat_speed: float) -> Vector:
        """Single speeds [m/s] of a ship of that squat speed, shape (cases,)."""
        if self.cases is not None:
            return np.array(self.cases, float)
        return np.array([readable(s * squat_speed, squat_speed) for s in self.case_shares])


def readable(value: float, scale: float) -> float:
    """`value` to the largest of 1, 2, 5 times a power of ten within 2 % of the positive `scale`."""
    power = math.floor(math.log10(_FINENESS * scale))
    step = next(n for n in (5, 2, 1) if n * 10.0**power <= _FINENESS * scale or n == 1)
    return round(round(value / (step * 10.0**power)) * step * 10.0**power, -power)
