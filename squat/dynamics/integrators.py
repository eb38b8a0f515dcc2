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


def positions(past: Sequence[Motion], dt: float, levels: int) -> list[Vector]:
    """Return q^n, q^{n-1}, ...: `levels` of them, continued before the start by a parabola."""
    found = [motion.position for motion in past[:levels]]
    oldest = past[len(found) - 1]
    for j in range(1, levels - len(found) + 1):
        back = j * dt
        found.append(oldest.position - back * oldest.velocity + back**2 / 2 * oldest.acceleration)
    return found


class Centred:
    """Centred differences, Eq. (17); the force is taken at the new level.

    w'' = (w^{n+1} - 2 w^n + w^{n-1}) / dt^2,   w' = (w^{n+1} - w^{n-1}) / (2 dt)

    Both stand at t_n while weight and buoyancy stand at t_{n+1}: first order, damped.
    """

    s1 = 0.5
    s3 = 1.0
    levels = 2

    def kinematics(self, past: Sequence[Motion], dt: float) -> Kinematics:
        """See `Integrator.kinematics`."""
        q0, q1 = positions(past, dt, 2)
        return Kinematics(-q1 / (2 * dt), self.s1, (q1 - 2 * q0) / dt**2, self.s3, dt)


class CentredBackward:
    """Eq. (17) with the velocity at t_{n+1}: w' = (3 w^{n+1} - 4 w^n + w^{n-1}) / (2 dt).

    The paper does not print the form of w'; with this one its scheme diverges (beta = 9/4).
    """

    s1 = 1.5
    s3 = 1.0
    levels = 2

    def kinematics(self, past: Sequence[Motion], dt: float) -> Kinematics:
        """See `Integrator.kinematics`."""
        q0, q1 = positions(past, dt, 2)
        return Kinematics((q1 - 4 * q0) / (2 * dt), self.s1, (q1 - 2 * q0) / dt**2, self.s3, dt)


class Backward:
    """Second-order backward differences, all at t_{n+1}.

    w'  = (3 w^{n+1} - 4 w^n + w^{n-1}) / (2 dt)
    w'' = (2 w^{n+1} - 5 w^n + 4 w^{n-1} - w^{n-2}) / dt^2
    """

    s1 = 1.5
    s3 = 2.0
    levels = 3

    def kinematics(self, past: Sequence[Motion], dt: float) -> Kinematics:
        """See `Integrator.kinematics`."""
        q0, q1, q2 = positions(past, dt, 3)
        a0 = (4 * q1 - 5 * q0 - q2) / dt**2
        return Kinematics((q1 - 4 * q0) / (2 * dt), self.s1, a0, self.s3, dt)


IntegratorName = Literal["newmark", "centred", "centred_backward", "backward"]
StepName = IntegratorName | Literal["energy_momentum"]
"""How a step is taken: by an integrator of the coupling loop, or with the fluid as one system."""
INTEGRATORS: dict[IntegratorName, Integrator] = {
    "newmark": Newmark(),
    "centred": Centred(),
    "centred_backward": CentredBackward(),
    "backward": Backward(),
}
