"""Ship and water in heave, from the curves a(w) and c(w) alone.

    U = rho g L w^2/2 - V^2 (a(w) + rho L w)/2,   M = m + c(w)

exact for hulls whose sides are vertical at the water line, which every hull's are. The same system
as `squat.fluid.energy.ShipEnergy` over the same curves, elementwise and a hundred times faster.
"""

from dataclasses import dataclass, replace

import numpy as np
from numpy.polynomial import Chebyshev
from numpy.polynomial.chebyshev import chebder, chebval
from numpy.typing import ArrayLike

from squat.channel import AnyHull
from squat.fluid.curves import Curves
from squat.quantities import Vector
from squat.stability.one_mode import Interval
from squat.water import Water


@dataclass(frozen=True, eq=False)
class Series:
    """A function of heave as a Chebyshev series in the logarithm of the clearance.

    Parameters
    ----------
    clearance
        Under-keel clearance at w = 0 [m].
    ends
        Logarithms of the least and the greatest clearance.
    coefficients
        Of the series and of its derivative by the logarithm.
    """

    clearance: float
    ends: tuple[float, float]
    coefficients: Vector
    derivative: Vector

    @staticmethod
    def of(clearance: float, series: Chebyshev) -> "Series":
        """A `Chebyshev` series in the logarithm of the clearance, with its derivative."""
        low, high = (float(end) for end in series.domain)
        derivative = chebder(series.coef) * 2 / (high - low)
        return Series(clearance, (low, high), np.asarray(series.coef), np.asarray(derivative))

    def _place(self, gap: Vector) -> Vector:
        low, high = self.ends
        return np.asarray((2 * np.log(gap) - low - high) / (high - low))

    def __call__(self, w: ArrayLike) -> Vector:
        """Value at w [m], elementwise."""
        gap = self.clearance + np.asarray(w, float)
        return np.asarray(chebval(self._place(gap), self.coefficients))

    def slope(self, w: ArrayLike) -> Vector:
        """Derivative by w, elementwise."""
        gap = self.clearance + np.asarray(w, float)
        return np.asarray(chebval(self._place(gap), self.derivative) / gap)


@dataclass(frozen=True, eq=False)
class HeaveSystem:
    """A `OneMode` in a current.

    Parameters
    ----------
    ship_mass
        m [kg/m].
    stiffness
        rho g L [N/m2].
    head
        rho L [kg/m2].
    stream
        a(w) [kg/m], twice the water's kinetic energy in unit current.
    inertia
        c(w) [kg/m], the water's inertia in heave.
    interval
        Heave that the curves cover.
    current
        V [m/s].
    """

    ship_mass: float
    stiffness: float
    head: float
    stream: Series
    inertia: Series
    interval: Interval
    current: float = 0.0

    @staticmethod
    def of(hull: AnyHull, water: Water, curves: Curves) -> "HeaveSystem":
        """The ship over the water's `curves`, in still water."""
        outline = hull.outline
        head = water.density * outline.length
        stream, _, inertia = (Series.of(curves.clearance, series) for series in curves.series)
        mass = water.density * outline.area
        return HeaveSystem(
            mass, head * water.gravity, head, stream, inertia, Interval(*curves.ends)
        )

    def at_current(self, current: float) -> "HeaveSystem":
        """The same ship in another current."""
        return replace(self, current=current)

    def mass(self, w: ArrayLike) -> Vector:
        """See `OneMode.mass`."""
        return self.ship_mass + self.inertia(w)

    def potential(self, w: ArrayLike) -> Vector:
        """See `OneMode.potential`; zero at w = 0 in still water."""
        w = np.asarray(w, float)
        stream = self.stream(w) + self.head * w
        return np.asarray(self.stiffness * w**2 / 2 - self.current**2 / 2 * stream)

    def slope(self, w: ArrayLike) -> Vector:
        """See `OneMode.slope`."""
        w = np.asarray(w, float)
        suction = self.stream.slope(w) + self.head
        return np.asarray(self.stiffness * w - self.current**2 / 2 * suction)
