"""Moving Submesh Approach: coarse triangles that follow the hull and carry the fine mesh."""

from collections import Counter
from collections.abc import Callable
from dataclasses import dataclass, field, replace
from functools import cached_property

import numpy as np

from squat.channel import Channel, Hull, check_afloat
from squat.errors import InputError
from squat.mesh.convex import cross
from squat.mesh.limits import FoldedError, Limits, PositionError
from squat.mesh.motion import MODES, Index, RigidMotion
from squat.mesh.zones import Zones, coarse
from squat.quantities import Vector

BOUNDARIES = ("In", "Out", "Botm", "FreeS", "Ship")


@dataclass(frozen=True, eq=False)
class Submesh:
    """Coarse triangulation of a channel around a hull, and its motion in `modes`.

    Parameters
    ----------
    triangles
        (nz, 3) indices of coarse vertices, counterclockwise.
    motion
        Positions of the coarse vertices.
    hull
        Indices of the rigid hull points, from the bow wall's foot to the stern wall's.
    keel
        Those of them that are closest to the bottom, bow to stern.
    bed
        Points of the bottom (n, 2) [m], In to Out.
    limits
        Admissible positions.
    modes
        Subset of surge, heave, pitch, in this order: what q holds.
    """

    triangles: Index
    motion: RigidMotion
    hull: Index
    keel: Index
    bed: Vector
    limits: Limits
    modes: tuple[str, ...] = MODES
    _last: dict[str, tuple[bytes, Vector]] = field(default_factory=dict, init=False, repr=False)

    def __post_init__(self) -> None:
        if not self.modes or [m for m in MODES if m in self.modes] != list(self.modes):
            raise InputError(f"modes={self.modes}: give some of {MODES}, in this order")

    @property
    def rest(self) -> Vector:
        """Coarse vertices (nc, 2) at q = 0 [m]."""
        return self.motion.rest

    @cached_property
    def free(self) -> list[int]:
        """Place of each mode in (surge, heave, pitch)."""
        return [MODES.index(mode) for mode in self.modes]

    def full(self, q: Vector) -> Vector:
        """(surge, heave, pitch) of `q`, which holds `modes` only; shape (3,)."""
        values = np.zeros(3)
        values[self.free] = np.asarray(q, float)
        return values

    def check(self, q: Vector) -> None:
        """Raise PositionError, naming the reason, unless `q` is admissible."""
        self.positions(q)

    def _refuse(self, full: Vector, moved: Vector) -> None:
        self.limits.check(full, moved[self.hull], clearance(moved[self.keel], self.bed))
        if self.areas(moved).min() <= 0:
            at = " ".join(f"{mode}={value:g}" for mode, value in zip(MODES, full, strict=True))
            raise FoldedError(
                f"{at}: folds the submesh at a corner of channel.bottom; give a smaller motion"
            )

    def positions(self, q: Vector) -> Vector:
        """Coarse vertices (nc, 2) [m] at `q`; raises PositionError where it is inadmissible."""
        return self._remembered("positions", q, self._checked)

    def _checked(self, q: Vector) -> Vector:
        full = self.full(q)
        if not np.all(np.isfinite(full)):
            raise PositionError(f"position={full.tolist()}: must be finite")
        moved = self.motion.positions(full)
        self._refuse(full, moved)
        return moved

    def _remembered(self, name: str, q: Vector, make: Callable[[Vector], Vector]) -> Vector:
        """`make(q)`, kept for the last q: stiffness, loads and pressure ask in turn."""
        key = np.asarray(q, float).tobytes()
        found = self._last.get(name)
        if found is None or found[0] != key:
            value = make(q)
            value.flags.writeable = False
            found = self._last[name] = (key, value)
        return found[1]

    def first(self, q: Vector) -> Vector:
        """dX/dq_k of the coarse vertices, shape (modes, nc, 2)."""
        return self._remembered("first", q, lambda q: self.motion.first(self.full(q), self.free))

    def second(self, q: Vector) -> Vector:
        """d2X/dq_k dq_l of the coarse vertices, shape (modes, modes, nc, 2)."""
        return self.motion.second(self.full(q))[np.ix_(self.free, self.free)]

    def center(self, q: Vector) -> Vector:
        """Moved point that pitch turns about, shape (2,) [m]."""
        return self.motion.center + self.full(q)[:2]

    def about(self, center: Vector) -> "Submesh":
        """The same, for pitch about another point of the hull, `center` (2,) [m] at rest."""
        return replace(self, motion=replace(self.motion, center=center))

    def clearance(self, q: Vector) -> float:
        """Least height [m] of the hull over the bottom at `q`, admissible or not."""
        return clearance(self.motion.positions(self.full(q))[self.keel], self.bed)

    def areas(self, vertices: Vector) -> Vector:
        """Signed areas (nz,) [m2] of the coarse triangles at `vertices` (nc, 2)."""
        a, b, c = (vertices[i] for i in self.triangles.T)
        return cross(a, b, c) / 2

    @cached_property
    def edges(self) -> Index:
        """All edges (ne, 2), each once, lower index first, sorted."""
        return np.unique(np.sort(_sides(self.triangles), axis=1), axis=0)

    @cached_property
    def boundary(self) -> dict[str, Index]:
        """Edges (k, 2) of each named boundary, the water on their left."""
        sides = _sides(self.triangles)
        count = Counter(map(tuple, np.sort(sides, axis=1).tolist()))
        outer = [side for side in sides.tolist() if count[tuple(sorted(side))] == 1]
        named: dict[str, list[list[int]]] = {name: [] for name in BOUNDARIES}
        for side in outer:
            named[self._name(side)].append(side)
        return {name: np.array(edges) for name, edges in named.items()}

    def _name(self, side: list[int]) -> str:
        x, z = self.rest[side].T
        if np.all(x == self.bed[0, 0]):
            return "In"
        if np.all(x == self.bed[-1, 0]):
            return "Out"
        if np.all(z == self.motion.level):
            return "FreeS"
        return "Ship" if set(side) & set(self.hull.tolist()) else "Botm"


def submesh(hull: Hull, channel: Channel, modes: tuple[str, ...] = MODES) -> Submesh:
    """Submesh of `hull` in `channel`; raises InputError where the geometry is impossible."""
    check_afloat(hull, channel)
    outline = hull.outline
    zones = coarse(outline, channel)
    bed = channel.bed(outline.length)
    center = outline.center + np.array([0.0, channel.depth])
    motion = RigidMotion(zones.rest, zones.anchors, center, channel.depth)
    return Submesh(
        np.array(zones.triangles),
        motion,
        np.array(zones.hull),
        np.array(zones.keel),
        bed,
        _limits(zones, hull, channel, bed),
        modes,
    )


def _limits(zones: Zones, hull: Hull, channel: Channel, bed: Vector) -> Limits:
    outline = hull.outline
    least = clearance(zones.rest[zones.keel], bed)
    return Limits(outline.draft, outline.wall_height, channel.depth, zones.reach, least)


def clearance(keel: Vector, bed: Vector) -> float:
    """Least height [m] of the hull points `keel` (n, 2) over the bottom `bed` (m, 2)."""
    own = keel[:, 1] - np.interp(keel[:, 0], bed[:, 0], bed[:, 1])
    under = bed[(bed[:, 0] > keel[0, 0]) & (bed[:, 0] < keel[-1, 0])]
    above = np.interp(under[:, 0], keel[:, 0], keel[:, 1]) - under[:, 1]
    return float(min(own.min(), above.min(initial=np.inf)))


def _sides(triangles: Index) -> Index:
    """Directed edges (3 nz, 2) of counterclockwise triangles."""
    return np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]])
