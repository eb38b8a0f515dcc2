"""Time integrators in affine form.

With the past known, every integrator here ties velocity and acceleration at the new level to
the new position q by

    q'  = v0 + s1 q / dt,        q'' = a0 + s3 q / dt^2.

The structure solver, the predictors and the amplification factors need nothing else.
"""

from collections.abc import Sequence
from typing import Literal, NamedTuple, Protocol

from squat.dynamics.motion import Motion
from squat.quantities import Vector


class Kinematics(NamedTuple):
    """The affine ties of one time step: v0, a0 of shape (n,); weights s1, s3; dt [s]."""

    v0: Vector
    s1: float
    a0: Vector
    s3: float
    dt: float

    def at_position(self, position: Vector) -> Motion:
        """Motion whose position is given."""
        velocity = self.v0 + (self.s1 / self.dt) * position
        return Motion(position, velocity, self.a0 + (self.s3 / self.dt**2) * position)

    def at_acceleration(self, acceleration: Vector) -> Motion:
        """Motion whose acceleration is given."""
        position = (self.dt**2 / self.s3) * (acceleration - self.a0)
        return Motion(position, self.v0 + (self.s1 / self.dt) * position, acceleration)


class Integrator(Protocol):
    """A time integrator: weights, the levels it looks back on, and the ties they imply."""

    s1: float
    s3: float
    levels: int

    def kinematics(self, past: Sequence[Motion], dt: float) -> Kinematics:
        """Ties of the step that follows `past` (newest first, at least one motion)."""
        ...


class Newmark:
    """Trapezoidal Newmark-Wilson rule, Eqs. (8) and (9); second order, conserves energy.

    w^{n+1}  = w^n + dt w'^n + dt^2/4 (w''^n + w''^{n+1})
    w'^{n+1} = w'^n + dt/2 (w''^n + w''^{n+1})
    """

    s1 = 2.0
    s3 = 4.0
    levels = 1

    def kinematics(self, past: Sequence[Motion], dt: float) -> Kinematics:
        """See `Integrator.kinematics`."""
        q, v, a = past[0]
        return Kinematics(
            -v - (2 / dt) * q, self.s1, -a - (4 / dt) * v - (4 / dt**2) * q, self.s3, dt
        )


class Centred:
    """Centred differences, Eq. (17); the force is taken at the new level.

    w''  = (w^{n+1} - 2 w^n + w^{n-1}) / dt^2,   w' = (w^{n+1} - w^{n-1}) / (2 dt)

    Both stand at t_n while weight and buoyancy stand at t_{n+1}: first order, damped. The level
    before the start is w^{-1} = w^0 - dt w'^0 + dt^2/2 w''^0.
    """

    s1 = 0.5
    s3 = 1.0
    levels = 2

    def kinematics(self, past: Sequence[Motion], dt: float) -> Kinematics:
        """See `Integrator.kinematics`."""
        q = past[0].position
        before = past[1].position if len(past) > 1 else self._before_start(past[0], dt)
        a0 = (before - 2 * q) / dt**2
        return Kinematics(-before / (2 * dt), self.s1, a0, self.s3, dt)

    @staticmethod
    def _before_start(start: Motion, dt: float) -> Vector:
        return start.position - dt * start.velocity + dt**2 / 2 * start.acceleration


IntegratorName = Literal["newmark", "centred"]
INTEGRATORS: dict[IntegratorName, Integrator] = {"newmark": Newmark(), "centred": Centred()}
