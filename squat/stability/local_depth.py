"""Eq. (27) over an uneven bottom: uniform flow under the keel, at the clearance found there.

Continuity and Bernoulli's equation with the water of Out, which has depth H and speed V:

    u(x) = V H/h(x),   p(x) = (rho/2) (V^2 - u^2),   h(x) = z_keel(x) + w - z_bed(x)

    force = int p dx,   moment = int p (x - x_G) dx   over the hull's length.

For a box two further terms of an expansion in h/L and h' are known (docs/theory/uneven.md): bow and
stern, exactly (`box_ends`), and the curvature of the streamlines over a slope, to second order.
"""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from scipy.optimize import minimize_scalar

from squat.channel import AnyHull, Channel, Rectangle, check_afloat
from squat.quantities import Vector
from squat.stability.box_ends import BoxEnd
from squat.stability.equilibria import Fold
from squat.water import Water

_NODES = 24
"""Gauss points between two corners of keel or bottom."""
_DEEPEST = 0.999
"""Part of the clearance that is searched for the fold."""


@dataclass(frozen=True, eq=False)
class LocalDepthModel:
    """A ship over any bottom, per unit width; all loads go with the square of the current.

    Parameters
    ----------
    complete
        Add what bow, stern and curvature do, which is known for boxes only.
    """

    hull: AnyHull
    channel: Channel
    water: Water
    complete: bool = False

    def __post_init__(self) -> None:
        check_afloat(self.hull, self.channel)
        assert not self.complete or isinstance(self.hull, Rectangle)

    @cached_property
    def depth(self) -> float:
        """H at Out [m]: where the water has the speed of the current."""
        return self._depth_at(self.hull.length + self.channel.downstream)

    @cached_property
    def _rule(self) -> tuple[Vector, Vector, Vector, Vector]:
        """Places x, weights, clearances at rest and their slopes dh/dx, shape (n,) each."""
        lower = self.hull.outline.vertices[1:-1]
        lower = lower[np.argsort(lower[:, 0], kind="stable")]
        corners = np.concatenate([lower[:, 0], self.channel.bed(self.hull.length)[:, 0]])
        ends = np.unique(np.clip(corners, lower[0, 0], lower[-1, 0]))
        nodes, weights = np.polynomial.legendre.leggauss(_NODES)
        half = np.diff(ends) / 2
        x = ((ends[:-1] + half)[:, None] + half[:, None] * nodes).ravel()

        def clearance(x: Vector) -> Vector:
            keel = self.channel.depth + np.interp(x, lower[:, 0], lower[:, 1])
            return np.asarray(keel - self.channel.floor(x))

        slope = np.diff(clearance(ends)) / (2 * half)
        return x, (half[:, None] * weights).ravel(), clearance(x), np.repeat(slope, _NODES)

    def force(self, w: float) -> float:
        """Vertical force over V^2 at heave `w` [m], positive up [N s2/m3]."""
        _, weight, h, slope = self._rule
        ratio = self.depth**2 / (h + w) ** 2
        total = weight @ (ratio - 1)
        if self.complete:
            total += self.depth**2 * (weight @ (slope / (h + w)) ** 2) / 3
            total += sum(self.depth**2 / end.gap**2 * end.length for end in self._ends(w))
        return float(-self.water.density / 2 * total)

    def moment(self, w: float) -> float:
        """Pitch moment over V^2 about the centre of gravity, positive bow down [N s2/m2]."""
        x, weight, h, slope = self._rule
        arm = x - self.hull.center_of_gravity[0]
        total = weight @ (arm * self.depth**2 / (h + w) ** 2)
        if self.complete:
            bow, stern = self._ends(w)
            bent = weight @ (arm * (slope / (h + w)) ** 2) + np.log(stern.gap / bow.gap)
            total += self.depth**2 * bent / 3
            total += self._end_moment(stern, 1) + self._end_moment(bow, -1)
        return float(-self.water.density / 2 * total)

    def _end_moment(self, end: BoxEnd, side: int) -> float:
        """Second moment of u^2 over V^2 [m2] that bow (-1) or stern (+1) adds."""
        x, z = self.hull.center_of_gravity
        lever = abs((0.0 if side < 0 else self.hull.length) - x)
        keel = lever * end.length - end.keel_moment
        wall = end.wall_moment(z + self.hull.draft)
        return float(side * (self.depth / end.gap) ** 2 * (keel + wall))

    def _ends(self, w: float) -> tuple[BoxEnd, BoxEnd]:
        """Bow and stern at heave `w`."""
        depths = [self._depth_at(x) for x in (0.0, self.hull.length)]
        bow, stern = (BoxEnd(depth - self.hull.draft + w, depth) for depth in depths)
        return bow, stern

    def _depth_at(self, x: float) -> float:
        return self.channel.depth - float(self.channel.floor(np.array(x)))

    def squat_speed(self) -> Fold:
        """Speed above which the force leaves no equilibrium in heave; the hull is kept level.

        rho g L w = force(w) V^2 gives V over w; the fold is its maximum.
        """
        spring = self.water.density * self.water.gravity * self.hull.outline.length

        def strength(w: float) -> float:
            return float(-spring * w / self.force(w))

        low = -_DEEPEST * float(self._rule[2].min())
        found = minimize_scalar(
            strength, bounds=(low, 0.0), method="bounded", options={"xatol": 1e-9}
        )
        return Fold(float(np.sqrt(-found.fun)), 0.0, float(found.x))
