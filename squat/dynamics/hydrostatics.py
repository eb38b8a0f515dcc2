"""Still water: potential energy of the displaced water and submerged area, exact for polygons."""

import math
from dataclasses import dataclass
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
    """The hull below z = H at one position: depths and rigid velocities along its chain."""

    def __init__(self, chain: Vector, arms: Vector, level: float) -> None:
        self.dx, self.dz = np.diff(chain, axis=0).T
        self.depth = level - chain[:, 1]
        self.arms = arms

    def area(self) -> float:
        """A_sub, the integral of depth dx [m2]."""
        d = self.depth
        return float(self.dx @ (d[:-1] + d[1:]) / 2)

    def moment(self) -> float:
        """Integral of the depth over the submerged area [m3]."""
        d, e = self.depth[:-1], self.depth[1:]
        return float(self.dx @ (d * d + d * e + e * e) / 6)

    def flux(self, mode: str, *, weighted: bool) -> float:
        """Integral of V_i.n ds over the hull, or of the depth times it; n into the hull."""
        x, z = self.arms.T
        u, v = {
            "surge": (np.ones_like(x), np.zeros_like(x)),
            "heave": (np.zeros_like(x), np.ones_like(x)),
            "pitch": (-z, x),
        }[mode]
        d = self.depth if weighted else np.ones_like(self.depth)
        start = v[:-1] * self.dx - u[:-1] * self.dz
        end = v[1:] * self.dx - u[1:] * self.dz
        return float(start @ (2 * d[:-1] + d[1:]) + end @ (d[:-1] + 2 * d[1:])) / 6


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

    def _below(self, q: Vector) -> _Below:
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
        return -self._weight * np.array([below.flux(mode, weighted=True) for mode in self.modes])

    def area(self, q: Vector) -> float:
        """A_sub [m2]."""
        return self._below(q).area()

    def area_gradient(self, q: Vector) -> Vector:
        """dA_sub/dq_i = -int_Ship V_i.n ds, shape (n,)."""
        below = self._below(q)
        return -np.array([below.flux(mode, weighted=False) for mode in self.modes])

    @property
    def _weight(self) -> float:
        return self.water.density * self.water.gravity
