"""Hull sections given by points, straight or smooth."""

import itertools
from abc import abstractmethod
from collections.abc import Callable
from typing import Annotated, Any, Literal

import numpy as np
import scipy  # its parts load on use: slow, and few hulls need them
from pydantic import Field, WrapValidator
from pydantic.dataclasses import dataclass
from shapely.geometry import LineString, box
from shapely.geometry import Polygon as Area

from squat.channel.hull import Hull, Segments
from squat.errors import InputError
from squat.quantities import STRICT, Length, Point, Vector

Points = Annotated[tuple[Point, ...], Field(min_length=3)]
_WIDE = 1e7
_NOTICED = 1e-3
"""Part of the length whose loss is remarked on."""
_LOOKS = 33
"""Points in which a stretch of a curve is looked at for its bend."""
_STRAIGHT = 1e-9
"""Part of the largest bend that is rounding."""


def _null_or(value: object, check: Callable[[object], Any]) -> Any:
    return value if value is None else check(value)


AsDrawn = Annotated[Length, WrapValidator(_null_or)]
"""Length [m]; null becomes what the points say, so that a hull's sizes are numbers for all."""
_AS_DRAWN: Any = None


@dataclass(frozen=True, kw_only=True, config=STRICT)
class _Given(Hull):
    """A section given by points (x, z), z upwards from the still water line, bow first.

    Parameters
    ----------
    length, draft
        L and T [m] that what lies below the water is stretched to. None: the points stay as they
        are, and L is their span at the foot of the walls, T their depth.
    wall
        Height [m] of the vertical sides below the still water line: what the points say above it
        is replaced by walls from there on (they stay as they are where they are vertical already).
    """

    length: AsDrawn = _AS_DRAWN
    draft: AsDrawn = _AS_DRAWN
    points: Points
    wall: Length

    def __post_init__(self) -> None:
        given: dict[str, float | None] = {"length": self.length, "draft": self.draft}
        if None not in given.values():
            return
        area = self._area()
        if given["draft"] is None:
            object.__setattr__(self, "draft", self._depth(area))
        if given["length"] is None:
            lower = self._lower(area)
            object.__setattr__(self, "length", float(lower[-1, 0] - lower[0, 0]))

    def section(self) -> Vector:
        """See `Hull.section`."""
        area = self._area()
        lower = self._lower(area)
        top = np.array([(lower[0, 0], 0.0), (lower[-1, 0], 0.0)])
        chain = np.concatenate([top[:1], lower, top[1:]])
        stretch = self.length / (chain[-1, 0] - chain[0, 0]), self.draft / self._depth(area)
        return np.asarray((chain - np.array([chain[0, 0], 0.0])) * np.array(stretch))

    def remark(self) -> str:
        """What the walls take off the length as drawn, where it is not given; empty: nothing."""
        area = self._area()
        left, _, right, _ = area.intersection(box(-_WIDE, -_WIDE, _WIDE, 0.0)).bounds
        drawn, kept = right - left, float(np.ptp(self._lower(area)[:, 0]))
        stretched = abs(self.length - kept) > _NOTICED * kept
        if stretched or kept > (1 - _NOTICED) * drawn:
            return ""
        return (
            f"the hull is {kept:.6g} m long of {drawn:.6g} m drawn: vertical sides replace what "
            f"lies above z = -hull.wall, hull.wall={self.wall:g} m; a smaller hull.wall= keeps more"
        )

    def _lower(self, area: Area) -> Vector:
        """Chain of `area`, as drawn, from the foot of one wall to that of the other."""
        if self.wall >= self.draft:
            raise InputError(
                f"hull.wall={self.wall:g}: must be less than hull.draft={self.draft:g}"
            )
        return self._cut(area, -self.wall / self.draft * self._depth(area))

    @staticmethod
    def _depth(area: Area) -> float:
        depth = -float(area.bounds[1])
        if depth <= 0:
            raise InputError("hull.points: none lies below the water line z=0; lower them")
        return depth

    @abstractmethod
    def curve(self) -> Vector:
        """Vertices of the closed section, shape (n, 2)."""

    def _area(self) -> Area:
        """The closed section as drawn."""
        self._check_ends()
        area = Area(self.curve())
        if not area.is_valid or area.area == 0:
            raise InputError("hull.points: the outline crosses itself; reorder the points")
        return area

    def _check_ends(self) -> None:
        """Refuse a list with an end below the water that is not closed above: it lacks a point."""
        wet = [end for end in (0, -1) if self.points[end][1] < 0]
        dry = {x for x, z in self.points if z >= 0}
        if wet and len(dry) < 2:
            which, (x, z) = ("first", "last")[wet[0]], self.points[wet[0]]
            raise InputError(
                f"hull.points: the {which} point, [{x:g}, {z:g}], lies below the water; "
                f"begin and end the list on the water line, say at [{x:g}, 0]"
            )

    @staticmethod
    def _cut(area: Area, foot: float) -> Vector:
        """Chain of `area` below z = foot, from bow to stern."""
        below = area.intersection(box(-_WIDE, -_WIDE, _WIDE, foot))
        top = below.intersection(LineString([(-_WIDE, foot), (_WIDE, foot)]))
        if not isinstance(below, Area) or not isinstance(top, LineString) or top.length == 0:
            raise InputError(
                "hull.points: the section meets the foot of its walls more than once; "
                "give one body, or another hull.wall"
            )
        ring = np.array(below.exterior.coords)[:-1]
        if not below.exterior.is_ccw:
            ring = ring[::-1]
        left, right = top.bounds[0], top.bounds[2]
        start = int(np.argmin(np.hypot(ring[:, 0] - left, ring[:, 1] - foot)))
        ring = np.roll(ring, -start, axis=0)
        end = int(np.argmin(np.hypot(ring[:, 0] - right, ring[:, 1] - foot)))
        return ring[: end + 1]


@dataclass(frozen=True, kw_only=True, config=STRICT)
class Polygon(_Given):
    """Any simple polygon: its corners, an open chain from water line to water line or closed."""

    shape: Literal["polygon"] = "polygon"

    def curve(self) -> Vector:
        """See `_Given.curve`."""
        return np.array(self.points, float)


@dataclass(frozen=True, kw_only=True, config=STRICT)
class Curve(_Given):
    """Any smooth closed curve: x and z over the chord length, each by monotone cubics.

    It goes neither beyond its points nor back between two of them, and is straight between two
    that share their x or z (Fritsch and Carlson 1980, with the slopes of Fritsch and Butland 1984).

    Parameters
    ----------
    segments
        Chords of all bends together, shared out so that each strays equally far from the curve;
        one from each point to the next at least, and where it is straight no more.
    """

    shape: Literal["curve"] = "curve"
    segments: Segments

    def curve(self) -> Vector:
        """See `_Given.curve`; every one of `points` is a vertex."""
        points = np.array(self.points, float)
        around = np.concatenate([points[-1:], points, points[:2]])  # slopes across the seam
        chords = np.linalg.norm(np.diff(around, axis=0), axis=1)
        if np.any(chords == 0):
            raise InputError("hull.points: two neighbours coincide; leave one out")
        s = np.concatenate([[0], np.cumsum(chords)])
        smooth = scipy.interpolate.PchipInterpolator(s, around)
        spans = list(itertools.pairwise(s[1:-1]))
        bends = np.array([_bend(smooth(np.linspace(*span, _LOOKS))) for span in spans])
        parts = [
            np.linspace(*span, int(n), endpoint=False)
            for span, n in zip(spans, self._shares(bends), strict=True)
        ]
        return np.asarray(smooth(np.concatenate(parts)))

    def _shares(self, bends: Vector) -> Vector:
        """Chords of each stretch: n of them stray from it by its bend over n^2."""
        roots = np.sqrt(np.where(bends > _STRAIGHT * bends.max(), bends, 0.0))
        return np.asarray(
            np.maximum(1, np.rint(self.segments * roots / max(roots.sum(), _STRAIGHT)))
        )


def _bend(stretch: Vector) -> float:
    """How far `stretch`, shape (n, 2), strays from its chord [m]."""
    along, offsets = stretch[-1] - stretch[0], stretch - stretch[0]
    across = offsets[:, 0] * along[1] - offsets[:, 1] * along[0]
    return float(np.abs(across).max() / np.hypot(*along))
