"""Under the keel: where that is, and the 1D model's flow there, uniform at V H / (H - T + w).

Apart from the equilibria that follow from it: pictures need no root finder.
"""

import numpy as np
from numpy.typing import ArrayLike, NDArray

from squat.quantities import Vector


def keel_pressure(density: float, speed: ArrayLike, depth: float, clearance: ArrayLike) -> Vector:
    """Pressure under the hull less hydrostatic [Pa], uniform in Eq. (27), elementwise.

    `speed` V [m/s] far away, `clearance` H - T + w [m] under the keel, `depth` H [m].
    """
    contraction = (depth / np.asarray(clearance, float)) ** 2
    return np.asarray(density * np.asarray(speed, float) ** 2 / 2 * (1 - contraction))


def squat_speed(depth: float, clearance: float, gravity: float) -> float:
    """Speed [m/s] above which Eq. (27) has no root, for H and H - T [m] and g [m/s2].

    Where both roots merge, the gap u = H - T + w has u^3 = V^2 H^2/g, and Eq. (27) becomes
    (u/H)^3 - 3 u/H + 2 (H - T)/H = 0, which the sine of a third of an angle solves.
    """
    gap = 2 * depth * np.sin(np.arcsin(clearance / depth) / 3)
    return float(np.sqrt(gravity * gap**3) / depth)


def breaks(nodes: NDArray[np.int64]) -> NDArray[np.int64]:
    """Where among `nodes` of `underside` the outline goes on elsewhere: lines break there."""
    return np.asarray(np.flatnonzero(np.diff(nodes) > 1) + 1, np.int64)


def underside(x: Vector, z: Vector) -> NDArray[np.int64]:
    """Numbers of the nodes of a hull's outline, in its order, where it faces down below 45 degrees.

    `x`, `z` (nodes,) [m], from bow to stern.
    """
    dx = np.diff(x)
    flat = dx > np.abs(np.diff(z))
    return np.asarray(np.flatnonzero(np.append(flat, False) | np.append(False, flat)), np.int64)
