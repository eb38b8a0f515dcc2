"""Physical quantities as checked types: what a configuration may hold, in SI units.

Every class of the configuration is a frozen pydantic dataclass over these types, so that a
number is checked once, where it enters, whether it comes from a file, a shell or Python.
"""

from typing import Annotated, Any

import numpy as np
from numpy.typing import NDArray
from pydantic import BeforeValidator, ConfigDict, Field

from squat.errors import InputError

Vector = NDArray[np.float64]
"""Real array; every docstring names its shape."""

STRICT = ConfigDict(extra="forbid")
"""Unknown keys are refused; give it as ``@dataclass(frozen=True, kw_only=True, config=STRICT)``."""


_PLANE = 2


class Unit(str):
    """Unit of a checked type, as part of it; `squat.config.units` reads it."""

    __slots__ = ()


def _number(**bounds: Any) -> Any:
    return Field(strict=True, allow_inf_nan=False, **bounds)


Real = Annotated[float, _number(ge=-1e12, le=1e12)]
Positive = Annotated[float, _number(gt=0, le=1e12)]
NonNegative = Annotated[float, _number(ge=0, le=1e12)]
Fraction = Annotated[float, _number(gt=0, le=1)]
Ratio = Annotated[Positive, Unit("1")]
"""Quotient of two quantities of one kind, positive."""
Length = Annotated[float, Unit("m"), _number(gt=0, le=1e5)]
"""Length [m] in (0, 1e5]."""
Area = Annotated[float, Unit("m2"), _number(gt=0, le=1e10)]
"""Area [m2] in (0, 1e10]."""
Position = Annotated[float, Unit("m"), _number(ge=-1e5, le=1e5)]
"""Coordinate or displacement [m]."""


def _pair(value: object) -> object:
    if isinstance(value, (list, tuple)) and len(value) != _PLANE:
        raise InputError(f"{list(value)} is no point; give [x, z], two numbers in m")
    return value


Point = Annotated[tuple[Position, Position], BeforeValidator(_pair)]
"""A point (x, z) [m]."""
Angle = Annotated[float, Unit("rad"), _number(ge=-1.5, le=1.5)]
"""Angle [rad], less than a right one either way."""
Velocity = Annotated[float, Unit("m/s"), _number(ge=-1e3, le=1e3)]
"""Velocity component [m/s]."""
Speed = Annotated[float, Unit("m/s"), _number(ge=0, le=1e3)]
"""Magnitude of a velocity [m/s]."""
Density = Annotated[float, Unit("kg/m3"), _number(gt=0, le=1e12)]
"""Mass over volume [kg/m3]."""
Acceleration = Annotated[float, Unit("m/s2"), _number(gt=0, le=1e12)]
"""Magnitude of an acceleration [m/s2]."""
Count = Annotated[int, Field(strict=True, ge=1, le=10**6)]
"""Positive integer, up to a million: what a run can hold or wait for."""
