"""Equilibria, folds and barriers of n modes over the current: continuation in lambda = V^2/2.

U(q; V) = U_0(q) - lambda s(q), linear in lambda, so that with G_0 = grad U_0 and G_1 = -grad s

    grad U = G_0 + lambda G_1 = 0

is one equation for each mode, in the unknowns q and lambda. Gam does not enter: it does no work and
vanishes at rest. Coordinates are x_i = l_i q_i, all metres.
"""

from collections.abc import Callable
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from scipy.optimize import root

from squat.dynamics.lagrangian import Lagrangian
from squat.mesh import PositionError
from squat.quantities import Vector

Family = Callable[[float], Lagrangian]
"""The system in a steady current of so many m/s."""
_DIFFERENCE = 1e-3
"""Step of second derivatives [m]: central differences of exact gradients."""


class Point(NamedTuple):
    """An equilibrium: q (n,), V [m/s] (NaN where V^2 < 0), negative eigenvalues of U''."""

    position: Vector
    current: float
    unstable: int


@dataclass(frozen=True, eq=False)
class Modes:
    """A ship of n modes over the current.

    Parameters
    ----------
    family
        Its energies.
    lengths
        l, shape (n,) [m a unit].
    """

    family: Family
    lengths: Vector

    def parts(self, x: Vector) -> tuple[Vector, Vector]:
        """G_0 and G_1 at x, shape (n,) each [N/m], [N s2/m3]."""
        q = x / self.lengths
        still, moving = self.family(0.0).gradient(q), self.family(1.0).gradient(q)
        return still / self.lengths, 2 * (moving - still) / self.lengths

    def gradient(self, x: Vector, strength: float) -> Vector:
        """grad U at lambda = `strength` [m2/s2], shape (n,)."""
        still, moving = self.parts(x)
        return still + strength * moving

    def jacobian(self, x: Vector, strength: float) -> Vector:
        """d(grad U)/d(x, lambda), shape (n, n + 1): U'' and G_1."""
        h, columns = _DIFFERENCE, []
        for e in np.eye(len(x)):
            ahead, behind = (self.gradient(x + k * h * e, strength) for k in (1, -1))
            columns.append((ahead - behind) / (2 * h))
        U2 = np.array(columns)
        return np.column_stack([(U2 + U2.T) / 2, self.parts(x)[1]])

    def point(self, x: Vector, strength: float) -> Point:
        """The equilibrium as it is recorded."""
        values = np.linalg.eigvalsh(self.jacobian(x, strength)[:, :-1])
        V = np.sqrt(2 * strength) if strength >= 0 else np.nan
        return Point(x / self.lengths, float(V), int((values < 0).sum()))

    def potential(self, x: Vector, current: float) -> float:
        """U [J/m] at x."""
        return self.family(current).potential(x / self.lengths)


def branch(
    modes: Modes, start: Vector, strength: float, toward: Vector, step: float, count: int
) -> list[Point]:
    """Equilibria by pseudo-arclength continuation, round folds, until out of reach.

    Parameters
    ----------
    start, strength
        An equilibrium: x (n,) and lambda.
    toward
        (n + 1,) a vector in (x, lambda) that the first step goes along.
    step
        Arc length [m], lambda counted in metres by the scale that makes both ends alike.
    count
        Most steps.
    """
    scale = np.append(np.ones(len(start)), strength_scale(modes, start))
    y, tangent = np.append(start, strength) / scale, toward / scale
    points = [modes.point(start, strength)]
    for _ in range(count):
        try:
            J = modes.jacobian(y[:-1], y[-1] * scale[-1]) * scale
            tangent = _tangent(J, tangent)
            y = _corrected(modes, y + step * tangent, tangent, scale)
            points.append(modes.point(y[:-1], y[-1] * scale[-1]))
        except PositionError:
            break
    return points


def strength_scale(modes: Modes, x: Vector) -> float:
    """Change of lambda [m2/s2] that moves an equilibrium by about a metre."""
    J = modes.jacobian(x, 0.0)
    return float(np.linalg.norm(J[:, :-1], 2)) / float(np.linalg.norm(J[:, -1]))


def _tangent(J: Vector, before: Vector) -> Vector:
    """Unit null vector of J (n, n + 1) that goes on from `before`."""
    null = np.linalg.svd(J)[2][-1]
    return np.asarray(null if null @ before >= 0 else -null)


def _corrected(modes: Modes, guess: Vector, tangent: Vector, scale: Vector) -> Vector:
    """Equilibrium in the plane through `guess` across `tangent`, by Newton's method."""
    y = guess
    for _ in range(12):
        x, strength = y[:-1], y[-1] * scale[-1]
        J = np.vstack([modes.jacobian(x, strength) * scale, tangent])
        change = np.linalg.solve(J, np.append(modes.gradient(x, strength), tangent @ (y - guess)))
        y = y - change
        if np.abs(change).max() < 1e-10:
            break
    return y


def fold(modes: Modes, near: Point) -> Point:
    """Fold of the branch near an equilibrium, its greatest current: the squat speed of n modes.

    Solved in (x, v, lambda): grad U = 0, U'' v = 0, g . v = 1, with g along G_1 and v along the
    branch. A fork, where another branch leaves, has det U'' = 0 as well but G_1 . v = 0: close by
    as it may be, it solves none of this (Seydel, Practical Bifurcation and Stability Analysis).
    """
    n, x = len(near.position), near.position * modes.lengths
    strength, scale = near.current**2 / 2, np.abs(modes.jacobian(x, 0.0)[0, 0])
    J = modes.jacobian(x, strength)
    g, v = J[:, -1] / np.linalg.norm(J[:, -1]), np.linalg.svd(J)[2][-1][:n]

    def equations(z: Vector) -> Vector:
        x, v, strength = z[:n], z[n : 2 * n], z[-1]
        U2 = modes.jacobian(x, strength)[:, :-1]
        return np.concatenate([modes.gradient(x, strength) / scale, U2 @ v / scale, [g @ v - 1]])

    found = root(equations, np.concatenate([x, v / (g @ v), [strength]]), tol=1e-12)
    return modes.point(np.asarray(found.x[:n]), float(found.x[-1]))
