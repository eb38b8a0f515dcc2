"""Equations of motion of ship and water, driven by a current and forces that vary in time.

    q' = M^-1 P,   P' = q'^T (dM/dq) q'/2 - dU/dq + Gam q' - b dV/dt + F,   P = M q', M = M_s + c

Stepped by the classical Runge-Kutta rule: fourth order, explicit, so that a step costs the same
whatever happens.
"""

import math
from dataclasses import replace
from typing import Any, NamedTuple, Protocol

import numpy as np
from numpy.typing import ArrayLike

from squat.dynamics.hydrostatics import heave_stiffness
from squat.errors import InputError
from squat.fluid.energy import ShipEnergy
from squat.quantities import Vector
from squat.reduced.model import ReducedModel
from squat.reduced.table import HeaveTable

Value = Any
"""A float in heave, an array (n,) in more modes."""


class Drive(NamedTuple):
    """What acts on the ship at one instant: V [m/s], dV/dt [m/s2], forces F [N/m]."""

    current: float
    rate: float
    force: Value

    def towards(self, other: "Drive", share: float) -> "Drive":
        """The drive on the way to another."""
        keep = 1 - share
        return Drive(
            keep * self.current + share * other.current,
            self.rate,
            keep * self.force + share * other.force,
        )


class Phase(NamedTuple):
    """Position q and momentum P: floats in heave, shape (n,) in more modes."""

    position: Value
    momentum: Value


class Place(NamedTuple):
    """Where the ship is and how fast: heave [m], m/s; pitch [rad], rad/s; clearance [m]."""

    heave: float
    heave_velocity: float
    pitch: float
    pitch_velocity: float
    clearance: float


class Motion(Protocol):
    """A ship whose motion can be stepped."""

    def force(self, given: ArrayLike) -> Value:
        """A force as it was given, checked."""
        ...

    def at_rest(self, position: Vector) -> Phase:
        """Phase of a ship at rest; PositionError out of the box."""
        ...

    def place(self, phase: Phase) -> Place:
        """What a user wants to know of a phase."""
        ...

    def advance(self, phase: Phase, dt: float, start: Drive, end: Drive) -> Phase:
        """Phase after `dt` [s], the drive varying linearly from `start` to `end`."""
        ...


class HeaveAlone:
    """Heave, in plain floats on a table of the reduced model: some ten microseconds a step."""

    def __init__(self, ship: ShipEnergy, table: HeaveTable) -> None:
        body, still = ship.body, ship.hydrostatics
        rho = still.water.density
        self._table, self._mass = table, body.mass
        self._spring = heave_stiffness(still.water, still.length)
        self._weight = body.gravity * (body.mass - rho * still.rest[1])
        self._head = rho * still.length

    def force(self, given: ArrayLike) -> float:
        """See `Motion.force`."""
        if isinstance(given, float) and math.isfinite(given):
            return given
        return float(_checked(given, 1)[0])

    def at_rest(self, position: Vector) -> Phase:
        """See `Motion.at_rest`."""
        w = float(position[0])
        self._table(w)
        return Phase(w, 0.0)

    def place(self, phase: Phase) -> Place:
        """See `Motion.place`."""
        w, P = phase
        velocity = P / (self._mass + self._table(w)[2])
        return Place(w, velocity, 0.0, 0.0, self._table.clearance + w)

    def advance(self, phase: Phase, dt: float, start: Drive, end: Drive) -> Phase:
        """See `Motion.advance`."""
        (w, P), (V0, R, F0), (V1, _, F1) = phase, start, end
        V, F, half = (V0 + V1) / 2, (F0 + F1) / 2, dt / 2
        v1, f1 = self._rate(w, P, V0, R, F0)
        v2, f2 = self._rate(w + half * v1, P + half * f1, V, R, F)
        v3, f3 = self._rate(w + half * v2, P + half * f2, V, R, F)
        v4, f4 = self._rate(w + dt * v3, P + dt * f3, V1, R, F1)
        w += dt / 6 * (v1 + 2 * (v2 + v3) + v4)
        return Phase(w, P + dt / 6 * (f1 + 2 * (f2 + f3) + f4))

    def _rate(self, w: float, P: float, V: float, R: float, F: float) -> tuple[float, float]:
        da, b, c, dc = self._table(w)
        v = P / (self._mass + c)
        steady = V * V / 2 * (da + self._head) - self._spring * w - self._weight
        return v, dc * v * v / 2 + steady - b * R + F


class ManyModes:
    """Any modes, on the reduced model itself: a few milliseconds a step."""

    def __init__(self, ship: ShipEnergy, model: ReducedModel) -> None:
        self._ship, self._model = ship, model

    def force(self, given: ArrayLike) -> Vector:
        """See `Motion.force`."""
        return _checked(given, len(self._model.modes))

    def at_rest(self, position: Vector) -> Phase:
        """See `Motion.at_rest`."""
        self._model.affine(position)
        return Phase(position, np.zeros_like(position))

    def place(self, phase: Phase) -> Place:
        """See `Motion.place`."""
        q, P = phase
        velocity = np.linalg.solve(self._ship.mass(q), P)
        clearance = self._model.box.clearance(q)
        return Place(float(q[0]), float(velocity[0]), float(q[1]), float(velocity[1]), clearance)

    def advance(self, phase: Phase, dt: float, start: Drive, end: Drive) -> Phase:
        """See `Motion.advance`."""
        middle = start.towards(end, 0.5)
        y = np.stack(phase)
        k1 = self._rate(y, start)
        k2 = self._rate(y + dt / 2 * k1, middle)
        k3 = self._rate(y + dt / 2 * k2, middle)
        k4 = self._rate(y + dt * k3, end)
        return Phase(*(y + dt / 6 * (k1 + 2 * k2 + 2 * k3 + k4)))

    def _rate(self, y: Vector, drive: Drive) -> Vector:
        q, P = y
        ship = replace(self._ship, current=drive.current)
        velocity = np.linalg.solve(ship.mass(q), P)
        kinetic = np.einsum("ijk,i,j->k", ship.mass_gradient(q), velocity, velocity) / 2
        force = kinetic - ship.gradient(q) + ship.gyroscopic(q) @ velocity + drive.force
        return np.stack([velocity, force - drive.rate * self._model.coefficients(q).b])


def _checked(given: ArrayLike, modes: int) -> Vector:
    force = np.array(given, float, ndmin=1)
    if force.shape == (1,) and not force.any():
        return np.zeros(modes)
    if force.shape != (modes,) or not np.all(np.isfinite(force)):
        raise InputError(f"external_force={given!r}: must be {modes} finite numbers")
    return force
