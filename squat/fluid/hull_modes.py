"""Displacement fields of the hull beyond rigid motion: the flexible modes of Eq. (24)."""

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from scipy.optimize import brentq

from squat.fem import Space, edge_normals
from squat.mesh import Mesh
from squat.quantities import Vector


@dataclass(frozen=True)
class HullMode:
    """A displacement per unit amplitude: `field` maps points (..., 2) [m] to vectors (..., 2)."""

    name: str
    field: Callable[[Vector], Vector]

    def load(self, mesh: Mesh, space: Space) -> Vector:
        """r = int_Ship V . n N ds, shape (size,); V linear between the nodes of an edge."""
        ends = mesh.points[mesh.boundary["Ship"]]
        velocity = np.asarray(self.field(ends))
        return np.asarray(
            space.spread("Ship", (velocity * edge_normals(ends)[:, None]).sum(axis=-1))
        )


def bending(number: int, bow: float, length: float) -> HullMode:
    """Vertical bending mode of a uniform free-free girder: cosh(kL) cos(kL) = 1.

    Parameters
    ----------
    number
        1 for the two-node mode, 2 for the three-node mode, ...
    bow, length
        Where the girder begins [m] and how long it is [m]; unit displacement at its bow.
    """
    middle = (number + 0.5) * math.pi
    kL = float(
        brentq(lambda x: math.cos(x) - 1 / math.cosh(x), middle - 0.5, middle + 0.5, xtol=1e-14)
    )
    ratio = (math.cosh(kL) - math.cos(kL)) / (math.sinh(kL) - math.sin(kL))

    def field(points: Vector) -> Vector:
        s = kL * (points[..., 0] - bow) / length
        shape = (np.cosh(s) + np.cos(s) - ratio * (np.sinh(s) + np.sin(s))) / 2
        return np.stack([np.zeros_like(shape), shape], axis=-1)

    return HullMode(f"bending_{number}", field)
