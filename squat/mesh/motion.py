"""Coarse vertices as functions of the rigid motion q = (surge, heave, pitch), with derivatives.

A hull point turns about the pitch centre c and moves with it,

    X(q) = c + (s, w) + R(theta) (X0 - c),   R = [[cos, -sin], [sin, cos]]  (positive: bow down),

a water line point slides along z = H on the turned side line through the foot F of its wall,
x = F_x - (H - F_z) tan(theta), and a point of the bottom stays below its hull point.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from squat.quantities import Vector

MODES = ("surge", "heave", "pitch")
FIXED, RIGID, WATERLINE, BED = range(4)
Index = NDArray[np.int64]


class Anchors(NamedTuple):
    """How each of nc coarse vertices moves.

    role
        FIXED, RIGID, WATERLINE or BED, shape (nc,).
    partner
        Hull vertex that a WATERLINE or BED vertex follows, shape (nc,).
    slope
        dz/dx of the bottom at a BED vertex, shape (nc,).
    """

    role: Index
    partner: Index
    slope: Vector


@dataclass(frozen=True, eq=False)
class RigidMotion:
    """Positions of the coarse vertices; `rest` (nc, 2), `center` (2,), water `level` H [m]."""

    rest: Vector
    anchors: Anchors
    center: Vector
    level: float

    def positions(self, q: Vector) -> Vector:
        """Coarse vertices (nc, 2) at q = (surge [m], heave [m], pitch [rad])."""
        arm = self.rest - self.center
        moved = self._spread(self.center + q[:2] + arm @ _turn(q[2]).T, self.rest)
        foot, water = self._feet(moved)
        moved[water, 0] = foot[:, 0] - (self.level - foot[:, 1]) * math.tan(q[2])
        moved[water, 1] = self.level
        return self._on_bed(moved, moved - self.rest, self.rest)

    def first(self, q: Vector, modes: Sequence[int] = (0, 1, 2)) -> Vector:
        """dX/dq_k for the places k of `modes` in q, shape (modes, nc, 2)."""
        arm = self.rest - self.center
        out = np.zeros((len(modes), *arm.shape))
        foot, water = self._feet(self.positions(q))
        tan, sec2 = math.tan(q[2]), 1 / math.cos(q[2]) ** 2
        for place, k in enumerate(modes):
            rate = np.eye(3)[k, :2] if k < 2 else arm @ _turn(q[2] + math.pi / 2).T
            moved = self._spread(np.broadcast_to(rate, arm.shape), np.zeros_like(arm))
            feet, _ = self._feet(moved)
            moved[water, 0] = feet[:, 0] + feet[:, 1] * tan
            if k == 2:
                moved[water, 0] -= (self.level - foot[:, 1]) * sec2
            out[place] = self._on_bed(moved, moved, np.zeros_like(arm))
        return out

    def second(self, q: Vector) -> Vector:
        """d2X/dq_k dq_l, shape (3, 3, nc, 2)."""
        arm = self.rest - self.center
        zero = np.zeros_like(arm)
        out = np.zeros((3, 3, *arm.shape))
        moved = self._spread(arm @ _turn(q[2] + math.pi).T, zero)
        feet, water = self._feet(moved)
        slide, _ = self._feet(self.first(q)[2])
        foot, _ = self._feet(self.positions(q))
        tan, sec2 = math.tan(q[2]), 1 / math.cos(q[2]) ** 2
        moved[water, 0] = feet[:, 0] + feet[:, 1] * tan + 2 * slide[:, 1] * sec2
        moved[water, 0] -= (self.level - foot[:, 1]) * 2 * sec2 * tan
        out[2, 2] = self._on_bed(moved, moved, zero)
        # The foot's height is w plus a function of theta: heave and pitch meet in h tan(theta).
        out[1, 2, water, 0] = out[2, 1, water, 0] = sec2
        return out

    def _spread(self, rigid: Vector, otherwise: Vector) -> Vector:
        """`rigid` at the hull's points, `otherwise` elsewhere."""
        moved = otherwise.copy()
        moved[self._rigid] = rigid[self._rigid]
        return moved

    def _feet(self, moved: Vector) -> tuple[Vector, Index]:
        """Values of `moved` at the feet of the walls, and their water line vertices."""
        return moved[self.anchors.partner[self._water]], self._water

    def _on_bed(self, moved: Vector, shift: Vector, base: Vector) -> Vector:
        """`moved` with the bottom's vertices shifted along it as their hull points are in x."""
        bed = self._bed
        dx = shift[self.anchors.partner[bed], 0]
        moved[bed, 0] = base[bed, 0] + dx
        moved[bed, 1] = base[bed, 1] + self.anchors.slope[bed] * dx
        return moved

    @cached_property
    def _rigid(self) -> Index:
        return np.flatnonzero(self.anchors.role == RIGID)

    @cached_property
    def _water(self) -> Index:
        return np.flatnonzero(self.anchors.role == WATERLINE)

    @cached_property
    def _bed(self) -> Index:
        return np.flatnonzero(self.anchors.role == BED)


def _turn(angle: float) -> Vector:
    """Rotation matrix by `angle` [rad] in (x, z)."""
    cos, sin = math.cos(angle), math.sin(angle)
    return np.array([[cos, -sin], [sin, cos]])
