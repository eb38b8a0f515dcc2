"""Still water: potential energy of the displaced water and submerged area, exact for polygons."""

import math
from dataclasses import dataclass, field
from functools import cached_property

import numpy as np

from squat.quantities import Vector
from squat.water import Water


def heave_stiffness(water: Water, length: float) -> float:
    """Restoring force per unit heave, rho g L [N/m2], for a water plane of `length` [m].

    Exact while the sides at the water line are vertical, which every hull's are.
    """
    return water.density * water.gravity * length


class _Below:
    """The hull below z = H at one position: its chain (k, 2), arms from the pitch centre (k, 2)."""

    def __init__(self, chain: Vector, arms: Vector, level: float) -> None:
        self.dx, self.dz = np.diff(chain, axis=0).T
        self.start, self.end = level - chain[:-1, 1], level - chain[1:, 1]
        self.arms = arms

    def area(self) -> float:
        """A_sub, the integral of depth dx [m2]."""
        return float(self.dx @ (self.start + self.end)) / 2

    def moment(self) -> float:
        """Integral of the depth over the submerged area [m3]."""
        d, e = self.start, self.end
        return float(self.dx @ (d * d + d * e + e * e)) / 6

    def _flux(self, mode: str) -> tuple[Vector, Vector]:
        """V_i.n times the length of each edge at its ends, n into the hull."""
        if mode != "pitch":
            rate = self.dx if mode == "heave" else -self.dz
            return rate, rate
        x, z = self.arms.T
        return x[:-1] * self.dx + z[:-1] * self.dz, x[1:] * self.dx + z[1:] * self.dz

    def flux(self, mode: str) -> float:
        """Integral of V_i.n ds over the hull."""
        start, end = self._flux(mode)
        return float(start.sum() + end.sum()) / 2

    def pressed(self, mode: str) -> float:
        """Integral of the depth times V_i.n ds over the hull."""
        (start, end), d, e = self._flux(mode), self.start, self.end
        return float(start @ (2 * d + e) + end @ (d + 2 * e)) / 6


@dataclass(frozen=True, eq=False)
class Hydrostatics:
    """U_h = rho g int_sub (H - z) dA and A_sub of a hull, for any subset of modes.

    Parameters
    ----------
    water
        Its density and gravity.
    chain
        Wetted polygon at rest (k, 2) [m] from the bow's water line point to the stern's, z from
        the bottom; first and last edge are the walls, which go on above the water.
    center
        Point that pitch turns about, at rest, shape (2,) [m].
    level
        H [m].
    modes
        What q holds, in the order surge, heave, pitch.
    """

    water: Water
    chain: Vector
    center: Vector
    level: float
    modes: tuple[str, ...]
    _last: dict[bytes, _Below] = field(default_factory=dict, init=False, repr=False)

    def _below(self, q: Vector) -> _Below:
        """The hull at q, kept for the last one asked for."""
        key = q.tobytes()
        if key not in self._last:
            self._last.clear()
            self._last[key] = self._moved(q)
        return self._last[key]

    def _moved(self, q: Vector) -> _Below:
        given = dict(zip(self.modes, q.tolist(), strict=True))
        angle = given.get("pitch", 0.0)
        center = self.center + np.array([given.get("surge", 0.0), given.get("heave", 0.0)])
        cos, sin = math.cos(angle), math.sin(angle)
        moved = center + (self.chain - self.center) @ np.array([[cos, sin], [-sin, cos]])
        for end, foot in ((0, 1), (-1, -2)):
            x, z = moved[foot]
            moved[end] = x - (self.level - z) * math.tan(angle), self.level
        return _Below(moved, moved - center, self.level)

    @cached_property
    def length(self) -> float:
        """Length of the water plane at rest [m]."""
        return float(self.chain[-1, 0] - self.chain[0, 0])

    @cached_property
    def rest(self) -> tuple[float, float]:
        """U_h [J/m] and A_sub [m2] at q = 0."""
        zero = np.zeros(len(self.modes))
        return self.potential(zero), self.area(zero)

    def potential(self, q: Vector) -> float:
        """U_h [J/m] at q (n,); zero for a hull out of the water."""
        return self._weight * self._below(q).moment()

    def gradient(self, q: Vector) -> Vector:
        """dU_h/dq_i = -int_Ship rho g (H - z) V_i.n ds, shape (n,): minus the buoyancy."""
        below = self._below(q)
        return -self._weight * np.array([below.pressed(mode) for mode in self.modes])

    @cached_property
    def stiffness(self) -> Vector:
        """d2U_h/dq_i dq_j at rest, shape (n, n).

        rho g times the length of the water plane, its first moment, and I_wp + A (z_B - z_c) for
        pitch about c: all of the restoring where c is the centre of gravity.
        """
        below = self._below(np.zeros(len(self.modes)))
        ends = self.chain[[0, -1], 0] - self.center[0]
        plane = [float(np.diff(ends ** (k + 1))[0]) / (k + 1) for k in range(3)]
        lever = self.level - below.moment() / below.area() - self.center[1]
        turning = plane[2] + below.area() * lever
        full = np.array([[0, 0, 0], [0, plane[0], plane[1]], [0, plane[1], turning]])
        free = [("surge", "heave", "pitch").index(mode) for mode in self.modes]
        return self._weight * full[np.ix_(free, free)]

    def area(self, q: Vector) -> float:
        """A_sub [m2]."""
        return self._below(q).area()

    def area_gradient(self, q: Vector) -> Vector:
        """dA_sub/dq_i = -int_Ship V_i.n ds, shape (n,)."""
        below = self._below(q)
        return -np.array([below.flux(mode) for mode in self.modes])

    @property
    def _weight(self) -> float:
        return self.water.density * self.water.gravity
