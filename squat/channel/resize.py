"""A hull in other sizes: stretched, without a change of its parameters, to a given area."""

from dataclasses import replace
from typing import Any, TypeVar

import scipy  # its parts load on use: slow, and few commands need them
from pydantic import ValidationError

from squat.channel.hull import Hull
from squat.errors import InputError

AHull = TypeVar("AHull", bound=Hull)
_EXACT = 1e-13
"""Of the stretch, relative: rounding of the area."""
_FIRST = 0.01
"""Change of the secant's second guess: small, since a hull has not every length that is tried."""


def resized(hull: AHull, **sizes: Any) -> AHull:
    """The hull with other `sizes`; raises InputError where it cannot have them."""
    try:
        return replace(hull, **sizes)
    except ValidationError as error:
        detail = error.errors(include_url=False)[0]
        reason = detail.get("ctx", {}).get("error", f"hull: {detail['msg']}")
        raise InputError(str(reason)) from error


def stretched(hull: AHull, displacement: float | None) -> AHull:
    """The hull with its length such that its submerged area is `displacement` [m2]; None: as it is.

    Raises
    ------
    InputError
        Where no length gives that area: say, corners that are cut off leave too little.
    """
    if displacement is None:
        return hull
    area = float(displacement)

    def excess(factor: float) -> float:
        return resized(hull, length=factor * hull.length).outline.area / area - 1

    guess = area / hull.outline.area
    try:
        # Areas are affine in the length, or nearly: two steps of the secant do.
        factor = float(scipy.optimize.newton(excess, guess, x1=(1 + _FIRST) * guess, rtol=_EXACT))
    except (InputError, RuntimeError) as error:
        raise InputError(
            f"displacement={area:g}: no length of this hull gives that area; give another, "
            f"or another hull.draft ({error})"
        ) from error
    return resized(hull, length=factor * hull.length)
