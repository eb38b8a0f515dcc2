"""Rectangle in a flat channel by eigenfunction matching: an independent reference.

The water left of the bow, under the keel and right of the stern are three rectangles; in each
the potential is a cosine series in z. They are matched at the two vertical lines under bow and
stern, where the unknown horizontal velocity is expanded in

    w_j(z) = (1 - (z/d)^2)^{-1/3} C_{2j}^{1/6}(z/d),   d = H - T,

functions that carry the corner's singularity r^{-1/3} exactly (Galerkin; their cosine transforms
are Bessel functions). The sums over n converge like n^{-4/3}; two lengths are extrapolated. Some
ten digits follow, without a mesh.

Modes are (g0, g1, s0, s1): a velocity g0 + g1 z along x on the sides and s0 + s1 x along z on the
keel, x from the bow, z from the bottom.
"""

from dataclasses import dataclass
from functools import cached_property
from typing import Literal, NamedTuple

import numpy as np
from scipy.special import gamma, jv

from squat.quantities import Vector

FreeSurface = Literal["zero_pressure", "rigid_lid"]
_NU = 1 / 6
_RATE = 4 / 3


class Mode(NamedTuple):
    """Velocity of the hull: g0 + g1 z along x (sides), s0 + s1 x along z (keel)."""

    g0: float
    g1: float
    s0: float
    s1: float


CURRENT = Mode(0.0, 0.0, 0.0, 0.0)


def rigid_modes(x_c: float, z_c: float) -> dict[str, Mode]:
    """Surge, heave and pitch (positive bow down) about (x_c, z_c)."""
    return {
        "surge": Mode(1, 0, 0, 0),
        "heave": Mode(0, 0, 1, 0),
        "pitch": Mode(z_c, -1, -x_c, 1),
    }


def _bessel(count: int, x: Vector) -> Vector:
    """J_(2j + 1/6)(x), shape (count, x); upwards by recurrence where x is beyond all orders.

    J_(v+1) = (2 v/x) J_v - J_(v-1), stable for x > v (Abramowitz and Stegun 9.1.27).
    """
    rows = np.empty((count, len(x)))
    near = x <= 2 * count
    rows[:, near] = jv(2 * np.arange(count)[:, None] + _NU, x[near])
    far = x[~near]
    low, high = jv(_NU, far), jv(_NU + 1, far)
    for j in range(count):
        rows[j, ~near] = low
        for order in (2 * j + 1 + _NU, 2 * j + 2 + _NU):
            low, high = high, 2 * order / far * high - low
    return rows


class _Solution(NamedTuple):
    bow: Vector
    stern: Vector
    constant: float
    outlet: float
    sides: Vector
    mode: Mode
    flux: float


@dataclass(frozen=True)
class _Series:
    """The matching with a given number of terms; lengths in m, density one."""

    length: float
    draft: float
    depth: float
    upstream: float
    downstream: float
    free_surface: FreeSurface
    terms: int
    functions: int

    @property
    def gap(self) -> float:
        """Clearance d under the keel [m]."""
        return self.depth - self.draft

    @property
    def lid(self) -> bool:
        """Whether the free surface is a rigid lid."""
        return self.free_surface == "rigid_lid"

    @cached_property
    def outer(self) -> Vector:
        """Wave numbers beside the ship, shape (terms,)."""
        shift = 0.0 if self.lid else 0.5
        return np.asarray((np.arange(self.terms) + shift) * np.pi / self.depth)

    @cached_property
    def inner(self) -> Vector:
        """Wave numbers under the keel, cut at the same value as outside."""
        count = int(self.terms * self.gap / self.depth)
        return np.asarray(np.arange(1, count + 1) * np.pi / self.gap)

    @cached_property
    def weights(self) -> Vector:
        """Inverse norms of the outer cosines."""
        weights = np.full(self.terms, 2 / self.depth)
        if self.lid:
            weights[0] = 1 / self.depth
        return weights

    def transform(self, k: Vector) -> Vector:
        """Cosine transforms of the w_j over the gap, divided by d; shape (functions, k)."""
        x = np.where(k > 0, k, 1.0) * self.gap
        rows = _bessel(self.functions, x) / x**_NU
        rows[:, k == 0] = self.mean[:, None]
        return np.asarray(rows, float)

    @cached_property
    def mean(self) -> Vector:
        """Transforms at k = 0: only w_0 has a mean."""
        mean = np.zeros(self.functions)
        mean[0] = 1 / (2**_NU * gamma(1 + _NU))
        return mean

    @cached_property
    def outer_transform(self) -> Vector:
        """Transforms at the outer wave numbers."""
        return self.transform(self.outer)

    @cached_property
    def inner_transform(self) -> Vector:
        """Transforms at the inner wave numbers."""
        return self.transform(self.inner)

    @cached_property
    def admittance(self) -> tuple[Vector, Vector]:
        """Pressure over normal velocity of each outer mode, upstream and downstream."""
        k = np.where(self.outer > 0, self.outer, 1.0)
        up = np.tanh(k * self.upstream) / k
        end = np.tanh(k * self.downstream)
        down = (1 / end if self.lid else end) / k
        if self.lid:
            up[0], down[0] = self.upstream, 0.0
        return up, down

    def side_integrals(self, mode: Mode) -> Vector:
        """Cosine integrals of the velocity over the hull's sides, shape (terms,)."""
        d, H = self.gap, self.depth
        zeroth, first = self._side_moments
        values = mode.g0 * zeroth + mode.g1 * first
        if self.lid:
            values[0] = mode.g0 * (H - d) + mode.g1 * (H**2 - d**2) / 2
        return np.asarray(values)

    @cached_property
    def _side_moments(self) -> tuple[Vector, Vector]:
        """Integrals over the sides of cos(k z), and of that times z."""
        d, H = self.gap, self.depth
        k = np.where(self.outer > 0, self.outer, 1.0)
        zeroth = (np.sin(k * H) - np.sin(k * d)) / k
        first = (H * np.sin(k * H) - d * np.sin(k * d)) / k
        first += (np.cos(k * H) - np.cos(k * d)) / k**2
        return zeroth, first

    @cached_property
    def _hyperbolic(self) -> tuple[Vector, Vector]:
        x = np.minimum(self.inner * self.length, 700.0)
        return 1 / np.tanh(x), 1 / np.sinh(x)

    def _forcing(self, mode: Mode) -> tuple[Vector, Vector]:
        """The keel's velocity in the inner cosines: F0 + F1 x, signs (-1)^m included."""
        common = 2 * self._signs / (self.gap * self.inner**2)
        return mode.s0 * common, mode.s1 * common

    @cached_property
    def _signs(self) -> Vector:
        return np.asarray(np.where(np.arange(1, self.inner.size + 1) % 2 == 0, 1.0, -1.0))

    @cached_property
    def _system(self) -> Vector:
        """Matrix of the matching at bow and stern, of the mean flow under the keel, of the flux."""
        J, d, mean = self.functions, self.gap, self.mean * self.gap
        W, V = self.outer_transform, self.inner_transform
        up, down = self.admittance
        coth, csch = self._hyperbolic
        same = (V * (2 * coth / self.inner)) @ V.T * d
        other = (V * (2 * csch / self.inner)) @ V.T * d
        size = 2 * J + (2 if self.lid else 1)
        matrix = np.zeros((size, size))
        matrix[:J, :J] = (W * (up * self.weights)) @ W.T * d**2 + same
        matrix[:J, J : 2 * J] = -other
        matrix[:J, 2 * J] = -mean
        matrix[J : 2 * J, :J] = other - np.outer(mean, mean) * self.length / d
        matrix[J : 2 * J, J : 2 * J] = -(W * (down * self.weights)) @ W.T * d**2 - same
        matrix[J : 2 * J, 2 * J] = -mean
        matrix[2 * J, :J], matrix[2 * J, J : 2 * J] = -mean, mean
        if self.lid:
            matrix[J : 2 * J, 2 * J + 1] = mean
            matrix[2 * J + 1, J : 2 * J] = mean
        return matrix

    def solve(self, mode: Mode, flux: float = 0.0) -> _Solution:
        """Potential with the hull moving in `mode`, and `flux` [m/s] leaving through Out."""
        J, d, L = self.functions, self.gap, self.length
        W, V, mean = self.outer_transform, self.inner_transform, self.mean * d
        (up, down), sides = self.admittance, self.side_integrals(mode)
        coth, csch = self._hyperbolic
        F0, F1 = self._forcing(mode)
        at_bow = V @ ((coth - csch) * F1 / self.inner + F0) * d
        at_stern = V @ ((csch - coth) * F1 / self.inner + F0 + F1 * L) * d
        at_stern -= mean * (mode.s0 * L**2 / 2 + mode.s1 * L**3 / 6) / d

        right = np.zeros(len(self._system))
        right[:J] = at_bow - W @ (up * self.weights * sides) * d
        right[J : 2 * J] = at_stern + W @ (down * self.weights * sides) * d
        right[2 * J] = -(mode.s0 * L + mode.s1 * L**2 / 2)
        if self.lid:
            right[2 * J + 1] = flux * self.depth - sides[0]
        x = np.asarray(np.linalg.solve(self._system, right), float)
        outlet = float(x[2 * J + 1]) if self.lid else 0.0
        return _Solution(x[:J], x[J : 2 * J], float(x[2 * J]), outlet, sides, mode, flux)

    def load(self, solution: _Solution, mode: Mode) -> float:
        """Integral over the hull of potential times normal velocity of `mode`."""
        sides, (up, down) = self.side_integrals(mode), self.admittance
        total = 0.0
        for end, admittance in ((solution.bow, up), (solution.stern, down)):
            velocity = self.weights * (self.gap * end @ self.outer_transform + solution.sides)
            total += float(np.sum(velocity * admittance * sides))
        total -= solution.outlet * float(sides[0])
        moments = self._keel_moments(solution)
        return total + mode.s0 * moments[0] + mode.s1 * moments[1]

    def _keel_moments(self, solution: _Solution) -> tuple[float, float]:
        """Integrals over the keel of the potential, and of the potential times x."""
        d, L, k = self.gap, self.length, self.inner
        s0, s1 = solution.mode.s0, solution.mode.s1
        coth, csch = self._hyperbolic
        F1 = self._forcing(solution.mode)[1]
        bow, stern = (
            2 * solution.bow @ self.inner_transform,
            2 * solution.stern @ self.inner_transform,
        )
        # Potential at the stern less that at the bow, in each inner cosine.
        rise = (bow + stern - 2 * F1) * (coth - csch) / k + F1 * L
        mean = float(self.mean @ solution.bow)
        C = solution.constant
        zeroth = C * L + mean * L**2 / 2 - s0 * L**3 / 6 / d - s1 * L**4 / 24 / d
        first = C * L**2 / 2 + mean * L**3 / 3 - s0 * L**4 / 8 / d - s1 * L**5 / 30 / d
        zeroth += d / 3 * (s0 * L + s1 * L**2 / 2) + float(
            np.sum(self._signs * (stern - bow) / k**2)
        )
        first += d / 3 * (s0 * L**2 / 2 + s1 * L**3 / 3)
        first += float(np.sum(self._signs * (L * stern - rise) / k**2))
        return zeroth, first


@dataclass(frozen=True)
class RectangleReference:
    """Exact added mass and flow energy of a rectangle [per unit density and width].

    Parameters
    ----------
    length, draft, depth, upstream, downstream
        L, T, H and the distances of In and Out [m].
    free_surface
        `zero_pressure` (Eq. 23) or `rigid_lid` (Eq. 19).
    terms, functions
        Terms of the longest series and functions on the gap; the defaults give ten digits in
        heave and six in surge and pitch; deep water wants more functions.
    """

    length: float
    draft: float
    depth: float
    upstream: float
    downstream: float
    free_surface: FreeSurface
    terms: int = 100_000
    functions: int = 16

    def _at(self, terms: int) -> _Series:
        geometry = self.length, self.draft, self.depth, self.upstream, self.downstream
        return _Series(*geometry, self.free_surface, terms, self.functions)

    def _extrapolated(self, coarse: Vector, fine: Vector) -> Vector:
        return np.asarray(fine + (fine - coarse) / (2**_RATE - 1), float)

    def added_mass(self, modes: dict[str, Mode]) -> Vector:
        """Matrix of shape (n, n) in the order of `modes`, over rho; a reciprocal pair each."""

        def matrix(terms: int) -> Vector:
            series = self._at(terms)
            solved = [series.solve(mode) for mode in modes.values()]
            return np.array([[series.load(s, mode) for s in solved] for mode in modes.values()])

        return self._extrapolated(matrix(self.terms // 2), matrix(self.terms))

    def current(self, modes: dict[str, Mode]) -> tuple[float, Vector]:
        """Under the lid, a/rho and b_j/rho of the flow with unit flux through Out (shape (n,))."""

        def energies(terms: int) -> Vector:
            series = self._at(terms)
            flow = series.solve(CURRENT, flux=1.0)
            a = self.depth * (flow.outlet + self.downstream)
            return np.array([a, *(series.load(flow, mode) for mode in modes.values())])

        found = self._extrapolated(energies(self.terms // 2), energies(self.terms))
        return float(found[0]), found[1:]
