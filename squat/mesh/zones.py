"""Coarse triangulation of a channel around a hull: the zones of the moving submesh.

Two vertical fences, one ahead of the bow and one behind the stern, bound the part that moves.
Below the hull every corner of its convex hull has a point of the bottom under it that follows
along the bottom, so that the strips between stay trapezoids for any position clear of the bottom.
Steep parts of bow and stern fan out to a point of the water line that follows the wall's foot,
over a helper that moves with the hull and so sees every edge for good. Pockets of a hull that is
not convex are triangles of hull points alone: they move rigidly. Outside of the fences nothing
moves.
"""

from dataclasses import dataclass, field
from itertools import pairwise

import numpy as np

from squat.channel import Channel, Outline
from squat.errors import InputError
from squat.mesh.convex import convex_hull, cross, triangulate
from squat.mesh.motion import BED, FIXED, RIGID, WATERLINE, Anchors
from squat.mesh.strips import followed, strip
from squat.quantities import Vector

_STEEP = 1.0 + 1e-9
"""Slope of a hull edge beyond which it belongs to bow or stern and not to the keel."""
_FENCE = 2.0
"""Distance between hull and fence over H, where the channel is that long."""

_CLEAR = 0.1
"""Height over H by which lines from the keel to the bottom clear what lies between."""
_SAME = 1e-9
"""Distance between a hull point and the corner of the bottom below it, over H, that is none."""
_INSIDE = 0.6
"""Distance between hull and helper, at most, over that to the water line's follower."""
_ASIDE, _APART, _OPEN = 1.2, 0.35, 0.4
"""Distance between hull and the water line's follower: over the depth of the steep part, over H,
and at most over that to the fence."""


@dataclass(eq=False)
class Zones:
    """The triangulation while it is being built.

    `chain`: hull points F_bow ... F_stern; `keel`: corners of the convex hull above the bottom's
    followers, by chain index; `bed`: for each of them its point of the bottom.
    """

    points: list[tuple[float, float]] = field(default_factory=list)
    role: list[int] = field(default_factory=list)
    partner: list[int] = field(default_factory=list)
    slope: list[float] = field(default_factory=list)
    triangles: list[tuple[int, int, int]] = field(default_factory=list)
    hull: list[int] = field(default_factory=list)
    keel: list[int] = field(default_factory=list)
    reach: float = 0.0

    def add(self, point: Vector, role: int = FIXED, partner: int = 0, slope: float = 0.0) -> int:
        """Index of a new vertex."""
        self.points.append((float(point[0]), float(point[1])))
        self.role.append(role)
        self.partner.append(partner)
        self.slope.append(slope)
        return len(self.points) - 1

    @property
    def rest(self) -> Vector:
        """Vertices (nc, 2) [m]."""
        return np.array(self.points)

    @property
    def anchors(self) -> Anchors:
        """How each vertex moves."""
        return Anchors(np.array(self.role), np.array(self.partner), np.array(self.slope))


def coarse(outline: Outline, channel: Channel) -> Zones:
    """Zones of `channel` around `outline`; raises InputError where they do not fit."""
    zones = Zones()
    level = channel.depth
    vertices = outline.vertices + np.array([0.0, level])
    zones.hull = [zones.add(p, RIGID) for p in vertices[1:-1]]
    outer = _outer(vertices[1:-1])
    for a, b in pairwise(outer):
        if b - a > 1:
            zones.triangles += triangulate(zones.rest, zones.hull[b : a - 1 if a else None : -1])
    first, last = _keel(vertices[1:-1], outer)
    zones.keel = outer[first : last + 1]
    bed = channel.bed(outline.length)
    under = _below_keel(zones, channel, bed)
    for side, end in ((-1, outer[: first + 1]), (1, outer[last:])):
        foot = end[0] if side < 0 else end[-1]
        water = zones.add((vertices[0] if side < 0 else vertices[-1]), WATERLINE, foot)
        _end(zones, side, end, water, under[0 if side < 0 else -1], bed, level)
    _check(zones)
    return zones


def _outer(chain: Vector) -> list[int]:
    """Corners of the convex hull of the hull points from bow foot to stern foot."""
    ring = convex_hull(chain)
    last = len(chain) - 1
    if 0 not in ring or last not in ring:
        raise InputError("hull: rises above the feet of its vertical sides; raise hull.wall")
    start = ring.index(0)
    ring = ring[start:] + ring[:start]
    return ring[: ring.index(last) + 1]


def _keel(chain: Vector, outer: list[int]) -> tuple[int, int]:
    """Positions in `outer` of the first and last corner between which no edge is steep."""
    edges = np.diff(chain[outer], axis=0)
    flat = np.flatnonzero((edges[:, 0] > 0) & (np.abs(edges[:, 1]) <= _STEEP * edges[:, 0]))
    if len(flat) == 0:
        lowest = int(np.argmin(chain[outer, 1]))
        return lowest, lowest
    return int(flat[0]), int(flat[-1]) + 1


def _below_keel(zones: Zones, channel: Channel, bed: Vector) -> list[int]:
    """Add the bottom under the keel and the strips between; its first and last point."""
    points = zones.rest[zones.keel]
    corners = bed[1:-1]
    chosen = followed(points[:, 0], corners[:, 0], float(channel.depth - points[:, 1].min()))
    below = [_follower(zones, channel, bed, zones.keel[i]) for i in chosen]
    for (i, start), (j, end) in pairwise(zip(chosen, below, strict=True)):
        x0, x1 = points[[i, j], 0]
        inner = [zones.add(p) for p in corners if x0 < p[0] < x1]
        zones.triangles += strip(zones.rest, zones.keel[i : j + 1], [start, *inner, end])
    return [below[0], below[-1]]


def _follower(zones: Zones, channel: Channel, bed: Vector, hull: int) -> int:
    """Point of the bottom below a hull point, which follows it along the bottom.

    On a corner of the bottom it stays: a follower would take the corner along.
    """
    x = zones.points[hull][0]
    if np.abs(bed[1:-1, 0] - x).min(initial=np.inf) < _SAME * channel.depth:
        return zones.add(np.array([x, float(channel.floor(np.array(x)))]))
    segment = int(np.clip(np.searchsorted(bed[:, 0], x, "right") - 1, 0, len(bed) - 2))
    dx, dz = bed[segment + 1] - bed[segment]
    return zones.add(np.array([x, float(channel.floor(np.array(x)))]), BED, hull, float(dz / dx))


def _end(
    zones: Zones, side: int, end: list[int], water: int, under: int, bed: Vector, level: float
) -> None:
    """Triangles between bow (side -1) or stern (+1) and its fence, and the fixed part beyond."""
    steep = end if side < 0 else end[::-1]  # from the foot of the wall to the keel
    outermost = side * max(side * zones.points[i][0] for i in steep)
    limit = bed[0 if side < 0 else -1, 0]
    x = outermost + side * min(_FENCE * level, side * (limit - outermost))
    corners = [p for p in bed[1:-1] if side * (p[0] - zones.points[under][0]) > 0]
    keel = steep[-1]
    close = [
        p
        for p in corners
        if side * (x - p[0]) > 0
        and side * (p[0] - outermost) > level / 2
        and _seen(zones.rest[keel], p, corners, _CLEAR * level)
    ]
    if close:
        x = min(close, key=lambda p: side * p[0])[0]
    top = zones.add(np.array([x, level]))
    foot = zones.add(np.array([x, np.interp(x, bed[:, 0], bed[:, 1])]))
    between = sorted(
        (tuple(p) for p in corners if side * (x - p[0]) > 0), key=lambda p: side * p[0]
    )
    floor = [under, *(zones.add(np.array(p)) for p in between), foot]
    fan = _over_floor(zones, side, keel, floor, _CLEAR * level)
    near = _surface(zones, steep, outermost, x, level)
    hub = _helper(zones, side, steep, abs(zones.points[near][0] - outermost))
    if hub is None:
        path = [foot, keel, *steep[-2::-1], water]
        fan += [(path[j], path[j + 1], near) for j in range(len(path) - 1)]
    else:
        path = [*steep[::-1], water]
        fan += [(path[j], path[j + 1], hub) for j in range(len(path) - 1)]
        fan += [(foot, keel, hub), (foot, hub, near), (hub, water, near)]
    fan += [(foot, near, top)]
    zones.triangles += fan if side < 0 else [(a, c, b) for a, b, c in fan]
    _beyond(zones, side, x, (top, foot), bed, level)
    zones.reach = min(zones.reach or np.inf, abs(x - outermost))


def _seen(eye: Vector, point: Vector, corners: list[Vector], room: float) -> bool:
    """Whether all corners of the bottom lie `room` [m] below the line from `eye` to `point`."""
    between = [c for c in corners if (c[0] - eye[0]) * (c[0] - point[0]) < 0]
    slope = (point[1] - eye[1]) / (point[0] - eye[0])
    return all(c[1] + room < eye[1] + slope * (c[0] - eye[0]) for c in between)


def _over_floor(
    zones: Zones, side: int, keel: int, floor: list[int], room: float
) -> list[tuple[int, int, int]]:
    """Triangles between the keel's end and the floor: a fan, unless a shelf hides some of it.

    The fan is taken if it would do for a keel that is lower by `room` [m], too, or by half of its
    height over the bottom.
    """
    eye, left, right = zones.rest[keel], zones.rest[floor[:-1]], zones.rest[floor[1:]]
    lowered = eye - np.array([0.0, min(room, (eye[1] - left[0, 1]) / 2)])
    if np.all(cross(left, lowered, right) * -side > 0):
        return [(a, keel, b) for a, b in pairwise(floor)]
    found = triangulate(zones.rest, [keel, *floor])
    return found if side < 0 else [(a, c, b) for a, b, c in found]


def _surface(zones: Zones, steep: list[int], outermost: float, fence: float, level: float) -> int:
    """A point of the water line that keeps its distance from the wall's foot."""
    depth = level - zones.points[steep[-1]][1]
    part = min(_OPEN * abs(fence - outermost), max(_ASIDE * depth, _APART * level))
    x = outermost + np.sign(fence - outermost) * part
    return zones.add(np.array([x, level]), BED, steep[0])


def _helper(zones: Zones, side: int, steep: list[int], room: float) -> int | None:
    """A point that moves with the hull, within `room` [m] of it, and sees all of a steep end."""
    if len(steep) < 2:
        return None
    points = zones.rest[steep]
    height = float(np.ptp(points[:, 1]))
    x = side * (side * points[:, 0]).max() + side * min(height, _INSIDE * room)
    hub = np.array([x, (points[:, 1].min() + points[:, 1].max()) / 2])
    seen = cross(points[1:], points[:-1], hub) * -side
    return zones.add(hub, RIGID) if np.all(seen > 0) else None


def _beyond(
    zones: Zones, side: int, x: float, fence: tuple[int, int], bed: Vector, level: float
) -> None:
    """The part of the channel outside of the fence, which stands still."""
    limit = bed[0 if side < 0 else -1]
    if x == limit[0]:
        return
    top, foot = fence
    outside = sorted(
        (tuple(p) for p in bed[1:-1] if side * (p[0] - x) > 0), key=lambda p: side * p[0]
    )
    ring = [top, foot, *(zones.add(np.array(p)) for p in outside)]
    ring += [zones.add(limit), zones.add(np.array([limit[0], level]))]
    zones.triangles += triangulate(zones.rest, ring)


def _check(zones: Zones) -> None:
    areas = cross(*(zones.rest[list(i)] for i in zip(*zones.triangles, strict=True)))
    if areas.min() <= 0:
        raise InputError(
            "channel: no moving submesh fits around this hull; move In and Out (channel.upstream, "
            "channel.downstream) or the points of channel.bottom away from bow and stern"
        )
