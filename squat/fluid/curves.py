"""a(w), b(w), c(w) of heave as smooth curves, from a score of solves.

They are analytic in the logarithm of the under-keel clearance; Chebyshev points there converge
geometrically.
"""

from dataclasses import dataclass

import numpy as np
from numpy.polynomial import Chebyshev

from squat.fluid.potential import PotentialFluid
from squat.quantities import Vector


@dataclass(frozen=True, eq=False)
class Curves:
    """Energy coefficients over heave w [m] and their derivatives.

    Parameters
    ----------
    clearance
        Under-keel clearance at w = 0 [m].
    series
        Chebyshev series of a, b, c [kg/m] in the logarithm of the clearance.
    """

    clearance: float
    series: tuple[Chebyshev, Chebyshev, Chebyshev]

    @staticmethod
    def of(fluid: PotentialFluid, low: float, high: float, points: int = 20) -> "Curves":
        """Curves from `points` positions between w = `low` and w = `high` [m]."""
        clearance = fluid.mesh.submesh.limits.clearance
        ends = np.log([clearance + low, clearance + high])
        nodes = np.cos(np.pi * (np.arange(points) + 0.5) / points)
        heave = np.exp(ends.mean() + np.diff(ends)[0] / 2 * nodes) - clearance
        found = [fluid.coefficients(np.array([w])) for w in heave]
        columns = (
            [value.a for value in found],
            [value.b[0] for value in found],
            [value.c[0, 0] for value in found],
        )
        a, b, c = (Chebyshev.fit(nodes, column, points - 1, domain=[-1, 1]) for column in columns)
        mapped = tuple(Chebyshev(s.coef, domain=ends, window=[-1, 1]) for s in (a, b, c))
        return Curves(clearance, (mapped[0], mapped[1], mapped[2]))

    def values(self, w: float) -> Vector:
        """a, b, c at w, shape (3,)."""
        u = np.log(self.clearance + w)
        return np.array([s(u) for s in self.series])

    def first(self, w: float) -> Vector:
        """da/dw, db/dw, dc/dw, shape (3,)."""
        gap = self.clearance + w
        return np.array([s.deriv()(np.log(gap)) / gap for s in self.series])

    def second(self, w: float) -> Vector:
        """Second derivatives, shape (3,)."""
        gap = self.clearance + w
        u = np.log(gap)
        return np.array([(s.deriv(2)(u) - s.deriv()(u)) / gap**2 for s in self.series])
