"""The ship in heave on the curves a(w), b(w), c(w): the pressure's time differences, no mesh."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.polynomial.chebyshev import chebder

from squat.coupling import Load, State
from squat.dynamics import Integrator, Motion
from squat.fluid.curves import Curves
from squat.fluid.rates import Levels, Rate
from squat.quantities import Vector


class Fast:
    """a', b, b', c, c' of `Curves` at one heave in microseconds, from one row of cosines."""

    def __init__(self, curves: Curves) -> None:
        low, high = curves.series[0].domain
        self.clearance, self.ends = curves.clearance, curves.ends
        self.middle, self.half = (low + high) / 2, (high - low) / 2
        a, b, c = (series.coef for series in curves.series)
        slopes = [np.append(chebder(series) / self.half, 0.0) for series in (a, b, c)]
        self.columns = np.stack([slopes[0], b, slopes[1], c, slopes[2]], axis=1)
        self.orders = np.arange(len(a))

    def __call__(self, w: float) -> tuple[float, float, float, float, float]:
        """da/dw, b, db/dw, c, dc/dw; not numbers beyond the curves' ends."""
        if not self.ends[0] <= w <= self.ends[1]:
            return (np.nan,) * 5
        gap = self.clearance + w
        place = np.arccos(np.clip((np.log(gap) - self.middle) / self.half, -1.0, 1.0))
        a1, b, b1, c, c1 = np.cos(self.orders * place) @ self.columns
        return a1 / gap, b, b1 / gap, c, c1 / gap


@dataclass(frozen=True)
class LightShip:
    """m w'' = -rho g L w + F_dyn with F_dyn = dT/dw - D_t (V b + w' c), T the water's energy.

    The pressure of Eq. (20), integrated exactly: D_t is the difference formula of d phi/dt at a
    node, and rho phi integrated over the hull is V b + w' c. So the iteration has the factor of
    docs/theory/coupled.md. The mass is varied at constant draft: a constant outside force holds
    the static balance.

    Parameters
    ----------
    curves
        Energy coefficients under the rigid lid.
    ship_mass
        m [kg/m].
    stiffness, lift
        rho g L [N/m2] and rho L V^2/2 [N/m].
    current
        V [m/s].
    rate
        Difference formula D_t.
    displacement
        w(0) [m].
    paper
        m_add of Eq. (23) at w = 0 [kg/m].
    """

    curves: Curves
    ship_mass: float
    stiffness: float
    lift: float
    current: float
    rate: Rate
    displacement: float
    paper: float

    @cached_property
    def _fast(self) -> Fast:
        return Fast(self.curves)

    @property
    def mass(self) -> Vector:
        """See `Entrant`."""
        return np.array([[self.ship_mass]])

    @property
    def omega(self) -> float:
        """sqrt(k/(m + c)) at w(0), k without the current's share."""
        c = self._fast(self.displacement)[3]
        return float(np.sqrt(self.stiffness / (self.ship_mass + c)))

    def load(self, trial: Motion, memory: Levels, dt: float) -> Load:
        """Force (1,) and the levels of V b + w' c."""
        w, v = float(trial.position[0]), float(trial.velocity[0])
        a1, b, b1, c, c1 = self._fast(w)
        current = self.current
        now = np.array([current * b + v * c])
        rate = self.rate(now, memory, dt)
        steady = current**2 * a1 / 2 + self.lift - self.stiffness * w
        force = steady + current * b1 * v + c1 * v**2 / 2 - rate
        return Load(force, Levels(now, memory.now, rate))

    def begin(self, dt: float) -> State:
        """Released from rest, in balance with its inertia and the water's."""
        w = self.displacement
        a1, b, _, c, _ = self._fast(w)
        net = self.current**2 * a1 / 2 + self.lift - self.stiffness * w
        acceleration = net / (self.ship_mass + c)
        now, rate = np.array([self.current * b]), np.array([c * acceleration])
        start = Motion(np.array([w]), np.zeros(1), np.array([acceleration]))
        return State((start,), Levels(now, now - dt * rate, rate))

    def _beta(self, integrator: Integrator) -> float:
        return integrator.s1 * self.rate.s2 / integrator.s3

    def inertia(self, position: Vector, integrator: Integrator) -> float:
        """beta c at `position`."""
        return self._beta(integrator) * self._fast(float(position[0]))[3]

    def tangent(self, integrator: Integrator, dt: float) -> float:
        """Nothing: buoyancy comes with the water's force."""
        return 0.0

    def fed_back(self, integrator: Integrator, dt: float) -> float:
        """beta c - ((s1 - s2)/s3) dt V b' + (dt^2/s3) (rho g L - V^2 a''/2) at the start."""
        w = self.displacement
        _, _, b1, c, _ = self._fast(w)
        bend = float(self.curves.second(w)[0])
        drag = (integrator.s1 - self.rate.s2) / integrator.s3 * dt * self.current * b1
        stiff = dt**2 / integrator.s3 * (self.stiffness - self.current**2 * bend / 2)
        return self._beta(integrator) * c - drag + stiff
