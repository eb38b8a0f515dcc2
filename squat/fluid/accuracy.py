"""Added mass to a stated error: three graded P2 meshes, extrapolated entry by entry."""

from collections.abc import Sequence
from functools import lru_cache
from typing import Annotated, NamedTuple

import numpy as np
from pydantic import Field
from pydantic.dataclasses import dataclass

from squat.channel import AnyHull, Channel
from squat.fluid.added_mass import AddedMass, FreeSurface
from squat.fluid.hull_modes import HullMode
from squat.mesh import MeshSize, submesh
from squat.mesh.generate import generate
from squat.quantities import STRICT, Fraction, Positive, Vector

LEVELS = 3
_LEAST_ORDER, _GREATEST_ORDER = 1.0, 4.0
_STEADY = 0.9
_ROUNDING = 1e-10
_KEPT = 128  # matrices of a few numbers


@dataclass(frozen=True, kw_only=True, config=STRICT)
class Accuracy:
    """Meshes of the extrapolation; lengths as fractions of the least of gap, draft and a = L/2.

    Parameters
    ----------
    near
        Element size near the hull on the finest mesh.
    far
        Element size far away over the depth, on the finest mesh.
    slope
        Growth of the size with the distance from the hull [m/m].
    grading
        Exponent towards the corners; P2 elements want more than 2/3 for full order.
    safety
        Factor on the estimated error, 1.25 with three meshes (Roache).
    refinement
        Ratio of the element sizes of one mesh and the next: 2, 3 or 4.
    """

    near: Fraction
    far: Fraction
    slope: Positive
    grading: Fraction
    safety: Positive
    refinement: Annotated[int, Field(strict=True, ge=2, le=4)]

    def size(self, hull: AnyHull, channel: Channel, level: int) -> MeshSize:
        """Sizes on mesh `level`, 0 the coarsest."""
        scale = min(channel.depth - hull.draft, hull.draft, hull.length / 2)
        factor = float(self.refinement) ** (LEVELS - 1 - level)
        return MeshSize(
            near=factor * self.near * scale,
            far=max(factor * self.far * channel.depth, factor * self.near * scale),
            slope=self.slope,
            grading=self.grading,
            corner_radius=max(scale, 1.1 * factor * self.near * scale),
            order=2,
        )


class Estimate(NamedTuple):
    """Extrapolated values and their absolute errors, arrays of one shape."""

    value: Vector
    error: Vector


def extrapolate(levels: Sequence[Vector], ratio: float, safety: float) -> Estimate:
    """Richardson's extrapolation with the observed order, where there is one.

    Where the changes of the last two refinements do not shrink by a steady factor, the finest
    value stands and the last change, times `safety`, is its error.

    Parameters
    ----------
    levels
        Values on three meshes, coarsest first, equal shapes.
    ratio
        Refinement of the element size from one to the next.
    """
    _, middle, fine = levels
    after = fine - middle
    scale = np.abs(fine).max(initial=0.0)
    order = observed_order(levels, ratio)
    steady = np.isfinite(order)
    gain = ratio ** np.minimum(np.where(steady, order, _LEAST_ORDER), _GREATEST_ORDER) - 1
    value = fine + np.where(steady, after / gain, 0.0)
    error = safety * np.abs(after) / gain + _ROUNDING * scale
    return Estimate(value, error)


def observed_order(levels: Sequence[Vector], ratio: float) -> Vector:
    """Order at which values on three meshes change; NaN where it is 0.9 or less, or none at all."""
    coarse, middle, fine = levels
    with np.errstate(divide="ignore", invalid="ignore"):
        order = np.log((middle - coarse) / (fine - middle)) / np.log(ratio)
        return np.where(np.isfinite(order) & (order > _STEADY), order, np.nan)


def accurate(
    hull: AnyHull,
    channel: Channel,
    accuracy: Accuracy,
    free_surface: FreeSurface,
    extra: Sequence[HullMode] = (),
) -> Estimate:
    """Matrix m(i, j)/rho of surge, heave, pitch and `extra`, with errors, shape (n, n).

    Kept for the process: runs of one ship at many currents solve for it once. Read-only arrays.
    """
    return _accurate(hull, channel, accuracy, free_surface, tuple(extra))


@lru_cache(maxsize=_KEPT)
def _accurate(
    hull: AnyHull,
    channel: Channel,
    accuracy: Accuracy,
    free_surface: FreeSurface,
    extra: tuple[HullMode, ...],
) -> Estimate:
    coarse = submesh(hull, channel)
    found = [
        AddedMass(generate(coarse, accuracy.size(hull, channel, level)), free_surface, extra).matrix
        for level in range(LEVELS)
    ]
    estimate = extrapolate(found, float(accuracy.refinement), accuracy.safety)
    for part in estimate:
        part.flags.writeable = False
    return estimate
