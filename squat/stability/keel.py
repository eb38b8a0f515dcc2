"""Water under the keel in the one-dimensional model, where it flows uniformly at V H / (H - T + w).

Apart from the equilibria that follow from it: pictures need no root finder.
"""

import numpy as np
from numpy.typing import ArrayLike

from squat.quantities import Vector


def keel_pressure(density: float, speed: ArrayLike, depth: float, clearance: ArrayLike) -> Vector:
    """Pressure under the hull less hydrostatic [Pa], uniform in Eq. (27), elementwise.

    `speed` V [m/s] far away, `clearance` H - T + w [m] under the keel, `depth` H [m].
    """
    contraction = (depth / np.asarray(clearance, float)) ** 2
    return np.asarray(density * np.asarray(speed, float) ** 2 / 2 * (1 - contraction))
