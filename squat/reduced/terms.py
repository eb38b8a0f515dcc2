"""The affine form with no more terms than its coefficients have independent functions.

In heave a zone's metric is [[d, -g w], [-g w, (1 + g^2 w^2)/d]] with d = 1 + k w: of the 36
coefficients around a rectangle 7 are independent, in heave and pitch 23. The others are constant
combinations of these, exactly, in q.
"""

from typing import NamedTuple

import numpy as np
from scipy.linalg import qr, solve_triangular

from squat.mesh.motion import Index
from squat.quantities import Vector

_DEPENDENT = 1e-13
"""Share of a coefficient, beyond what the chosen ones span, that counts as rounding."""


class ShortForm(NamedTuple):
    """theta(q) = weights @ theta(q)[chosen]; weights (terms, kept), chosen (kept,)."""

    chosen: Index
    weights: Vector

    @staticmethod
    def of(samples: Vector) -> "ShortForm":
        """From coefficients at many positions, shape (terms, samples)."""
        size = np.abs(samples).max(axis=1)
        size[size == 0] = 1
        R, order = qr((samples / size[:, None]).T, mode="r", pivoting=True)
        pivots = np.abs(np.diag(R))
        kept = int((pivots > _DEPENDENT * pivots[0]).sum())
        chosen = order[:kept]
        weights = np.zeros((len(samples), kept))
        weights[order] = np.vstack(
            [np.eye(kept), solve_triangular(R[:kept, :kept], R[:kept, kept:]).T]
        )
        return ShortForm(chosen, size[:, None] * weights / size[chosen])
