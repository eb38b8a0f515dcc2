"""The channel's longitudinal section."""

from itertools import pairwise

import numpy as np
from pydantic.dataclasses import dataclass

from squat.channel.hull import Hull
from squat.errors import InputError
from squat.quantities import STRICT, Length, Point, Vector

_SHORT = 1.25
"""Ship's length over that from In to the bow, 1 in the paper, from which on it is remarked on: the
period is then some 5 % shorter than in the paper's proportions."""


@dataclass(frozen=True, kw_only=True, config=STRICT)
class Channel:
    """Channel around a ship (Fig. 3, section 3.6).

    Parameters
    ----------
    depth
        H [m], from the level z = 0 to the water line.
    upstream
        Distance from the bow to the boundary In [m].
    downstream
        Distance from the stern to the boundary Out [m].
    bottom
        Points (x, z) [m] of the bottom, x from the bow towards the stern, increasing; level before
        the first and after the last. Empty: flat, z = 0.
    """

    depth: Length
    upstream: Length
    downstream: Length
    bottom: tuple[Point, ...] = ()

    def __post_init__(self) -> None:
        for (x0, _), (x1, _) in pairwise(self.bottom):
            if x1 <= x0:
                raise InputError(f"channel.bottom: x={x1:g} follows x={x0:g}; give them increasing")
        for x, z in self.bottom:
            if z >= self.depth:
                raise InputError(
                    f"channel.bottom: z={z:g} at x={x:g} must be below channel.depth={self.depth:g}"
                )

    def floor(self, x: Vector) -> Vector:
        """Height z [m] of the bottom at `x` [m] from the bow, elementwise."""
        if not self.bottom:
            return np.zeros_like(x)
        points = np.array(self.bottom)
        return np.asarray(np.interp(x, points[:, 0], points[:, 1]))

    def bed(self, length: float) -> Vector:
        """Bottom from In to Out, shape (n, 2) [m], for a ship of `length` [m]."""
        ends = np.array([-self.upstream, length + self.downstream])
        inner = [p for p in self.bottom if ends[0] < p[0] < ends[1]]
        low, high = self.floor(ends)
        return np.array([(ends[0], low), *inner, (ends[1], high)])

    def remark(self, hull: Hull) -> str:
        """What a user under the rigid lid should be told of In for `hull`; empty: nothing."""
        length = hull.length
        if length <= _SHORT * self.upstream:
            return ""
        return (
            f"channel.upstream={self.upstream:g}: short for a hull {length:g} m long; under the "
            "rigid lid periods grow with it, since all displaced water leaves there; the paper has "
            f"In one length ahead, channel.upstream={length:g}, and Out one and a half behind, "
            f"channel.downstream={1.5 * length:g}"
        )


def check_afloat(hull: Hull, channel: Channel) -> None:
    """Raise InputError unless `hull` floats clear of the bottom of `channel`."""
    if hull.draft >= channel.depth:
        raise InputError(
            f"hull.draft={hull.draft:g}: must be less than channel.depth={channel.depth:g}"
        )
    if channel.bottom and _clearance(hull, channel) <= 0:
        raise InputError(
            f"hull.draft={hull.draft:g}: the hull touches channel.bottom; lower the bottom there"
        )


def _clearance(hull: Hull, channel: Channel) -> float:
    """Least height [m] of the hull at rest over the bottom, at the vertices of both."""
    vertices = hull.outline.vertices[1:-1]
    own = vertices[:, 1] + channel.depth - channel.floor(vertices[:, 0])
    lower = vertices[np.argsort(vertices[:, 0], kind="stable")]
    bed = channel.bed(hull.length)
    under = bed[(bed[:, 0] > 0) & (bed[:, 0] < hull.length)]
    above = np.interp(under[:, 0], lower[:, 0], lower[:, 1]) + channel.depth - under[:, 1]
    return float(min([*own, *above]))
