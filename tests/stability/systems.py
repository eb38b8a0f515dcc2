"""Systems of one mode whose answers are known in closed form."""

from dataclasses import dataclass

import numpy as np
from scipy.special import ellipk

from squat.stability.one_mode import Interval

PENDULUM_RANGE, HEAVE_RANGE = Interval(-3.0, 3.0), Interval(-9.9, 5.0)


@dataclass(frozen=True)
class Pendulum:
    """U = k (1 - cos w), M constant: period by the complete elliptic integral."""

    k: float = 3.0
    inertia: float = 2.0
    interval: Interval = PENDULUM_RANGE

    def mass(self, w):
        return np.full_like(np.asarray(w, float), self.inertia)

    def potential(self, w):
        return self.k * (1 - np.cos(w))

    def slope(self, w):
        return self.k * np.sin(w)

    def period(self, amplitude):
        return 4 * np.sqrt(self.inertia / self.k) * ellipk(np.sin(amplitude / 2) ** 2)


@dataclass(frozen=True)
class Cubic:
    """dU/dw = (w - w_f)^2 - (V_f^2 - V^2): a fold at V_f, everything in closed form.

    With x = w - w_f and r^2 = V_f^2 - V^2, U = x^3/3 - r^2 x; the unstable root is x = -r, the
    stable one x = r, and U - U(-r) = (x + r)^2 (x - 2 r)/3.
    """

    current: float
    fold_speed: float = 2.5
    fold_place: float = -3.0
    inertia: float = 1.5
    interval: Interval = HEAVE_RANGE

    def at_current(self, V):
        return Cubic(V, self.fold_speed, self.fold_place, self.inertia, self.interval)

    @property
    def r2(self):
        return self.fold_speed**2 - self.current**2

    def mass(self, w):
        return np.full_like(np.asarray(w, float), self.inertia)

    def potential(self, w):
        x = np.asarray(w, float) - self.fold_place
        return x**3 / 3 - self.r2 * x

    def slope(self, w):
        return (np.asarray(w, float) - self.fold_place) ** 2 - self.r2

    def period(self, energy):
        """U - E = (x - x1)(x - x2)(x - x3)/3; the ship moves between x2 and x3."""
        x1, x2, x3 = np.sort(np.roots([1 / 3, 0, -self.r2, -energy]).real)
        scale = 2 * np.sqrt(3 * self.inertia / 2)
        return scale * 2 / np.sqrt(x3 - x1) * ellipk((x3 - x2) / (x3 - x1))

    def loop_area(self):
        """Area inside the separatrix in the plane of w and M w'."""
        r = np.sqrt(self.r2)
        return 2 * np.sqrt(2 * self.inertia / 3) * 4 / 15 * (3 * r) ** 2.5
