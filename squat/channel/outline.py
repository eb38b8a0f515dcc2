"""The wetted section as a polygon: what mesh, hydrostatics and motion need of any hull."""

from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from shapely.geometry import Polygon

from squat.errors import InputError
from squat.quantities import Vector

_TINY = 1e-9


@dataclass(frozen=True, eq=False)
class Outline:
    """Wetted polygon at rest, hull coordinates (z = 0 on the still water line).

    Parameters
    ----------
    vertices
        (n, 2) [m]: bow water line point, foot of its wall, ..., foot of the stern's wall, stern
        water line point; counterclockwise, no three in line.
    area
        Submerged area [m2], exact for the polygon; ship mass per unit width is rho times it.
    centroid
        Of the submerged area, shape (2,) [m].
    center
        Point that pitch turns about, shape (2,) [m].
    """

    vertices: Vector
    area: float
    centroid: Vector
    center: Vector

    @staticmethod
    def of(chain: Vector, draft: float, pitch_center: str) -> "Outline":
        """Outline of a wetted chain (n, 2); raises InputError where it is no hull section."""
        if not np.all(np.isfinite(chain)):
            raise InputError("hull: outline has a number that is not finite; check its sizes")
        chain = _upright(_without_idle(chain, draft), draft)
        polygon = Polygon(chain)
        if not polygon.is_valid or polygon.area <= 0 or not polygon.exterior.is_ccw:
            raise InputError("hull: outline crosses itself; check its sizes or reorder its points")
        if chain[1:-1, 1].max() >= 0 or chain[0, 0] >= chain[-1, 0]:
            raise InputError("hull: outline leaves the water between bow and stern; lower it")
        if chain[0, 0] != chain[1, 0] or chain[-1, 0] != chain[-2, 0]:
            raise InputError("hull: sides are not vertical at the water line; give hull.wall=")
        area, centroid = moments(chain)
        middle = np.array([chain[[0, -1], 0].mean(), 0.0])
        return Outline(chain, area, centroid, middle if pitch_center == "waterline" else centroid)

    @property
    def wall_height(self) -> float:
        """Height [m] of the lower of the two vertical sides: the bound of upward motion."""
        return float(-self.vertices[[1, -2], 1].max())

    @property
    def length(self) -> float:
        """Length of the water plane [m]."""
        return float(self.vertices[-1, 0] - self.vertices[0, 0])

    @property
    def draft(self) -> float:
        """Depth of the lowest point [m]."""
        return float(-self.vertices[:, 1].min())


def moments(polygon: Vector) -> tuple[float, Vector]:
    """Area and centroid (2,) of a counterclockwise polygon (n, 2), exact."""
    after = np.roll(polygon, -1, axis=0)
    cross = polygon[:, 0] * after[:, 1] - after[:, 0] * polygon[:, 1]
    area = float(cross.sum() / 2)
    return area, np.asarray(((polygon + after) * cross[:, None]).sum(axis=0) / (6 * area))


def _upright(chain: Vector, size: float) -> Vector:
    """`chain` with its first and last edges exactly vertical where rounding alone tilts them."""
    chain = np.array(chain, float)
    for end, foot in ((0, 1), (-1, -2)):
        if abs(chain[foot, 0] - chain[end, 0]) < _TINY * size:
            chain[foot, 0] = chain[end, 0]
    return chain


def _without_idle(chain: Vector, size: float) -> Vector:
    """`chain` without points that coincide with, or lie in line between, their neighbours."""
    kept = [chain[0]]
    for here, after in pairwise(chain[1:]):
        a, b = here - kept[-1], after - here
        if abs(a[0] * b[1] - a[1] * b[0]) > _TINY * size * np.linalg.norm(b) and a @ a > 0:
            kept.append(here)
    return np.array([*kept, chain[-1]])
