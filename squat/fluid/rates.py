"""The time derivative of the potential at a moving node, in affine form.

The paper asks for "second order" and prints no formula. Each choice here reads

    d phi/dt |node = s2 phi^k / dt + (known from accepted steps).
"""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Literal, NamedTuple

from squat.quantities import Vector

RateName = Literal["centred", "backward", "backward_euler", "trapezoidal"]


class Levels(NamedTuple):
    """What the accepted steps leave: phi^n, phi^{n-1} and d phi/dt at t_n, shape (nodes,) each."""

    now: Vector
    before: Vector
    rate: Vector


@dataclass(frozen=True)
class Rate:
    """One difference formula: its weight s2 of the new level, and its order."""

    s2: float
    order: int
    known: Callable[[Levels, float], Vector]

    def __call__(self, potential: Vector, levels: Levels, dt: float) -> Vector:
        """Return d phi/dt [m2/s2] at the nodes for the new `potential`, shape (nodes,)."""
        return self.s2 / dt * potential + self.known(levels, dt)


RATES: dict[RateName, Rate] = {
    # (phi^{n+1} - phi^{n-1})/(2 dt): stands at t_n; with Eq. (17) the reading that converges.
    "centred": Rate(0.5, 2, lambda old, dt: -0.5 / dt * old.before),
    # (3 phi^{n+1} - 4 phi^n + phi^{n-1})/(2 dt)
    "backward": Rate(1.5, 2, lambda old, dt: (old.before - 4 * old.now) / (2 * dt)),
    # (phi^{n+1} - phi^n)/dt: what "second order selected" was selected against.
    "backward_euler": Rate(1.0, 1, lambda old, dt: -old.now / dt),
    # phi^{n+1} = phi^n + dt/2 (rate^n + rate^{n+1})
    "trapezoidal": Rate(2.0, 2, lambda old, dt: -2 / dt * old.now - old.rate),
}
