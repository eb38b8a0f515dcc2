"""A ship for simulators: set it free, then step it through any current and forces."""

import math
from itertools import pairwise
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from squat.dynamics import RigidBody
from squat.errors import InputError
from squat.fluid.curves import Curves
from squat.fluid.energy import ShipEnergy, still_water
from squat.mesh import GroundedError
from squat.reduced.motion import Drive, HeaveAlone, ManyModes, Motion, Place
from squat.reduced.record import Loaded, load
from squat.reduced.table import HeaveTable
from squat.water import Water

_POINTS = 32
"""Positions that the curves of heave are made from: slopes to 1e-11."""


class State(NamedTuple):
    """The ship at one instant, SI units and radians.

    Parameters
    ----------
    time
        Since the start [s].
    heave, heave_velocity
        Positive up [m], [m/s].
    pitch, pitch_velocity
        Positive bow down [rad], [rad/s]; zero for a model of heave alone.
    clearance
        Least height of the hull over the bottom [m].
    current
        V of the water relative to the ship [m/s].
    grounded
        The ship came closer to the bottom than the model reaches; from then on it stays where it
        was at most `max_step` before.
    """

    time: float
    heave: float
    heave_velocity: float
    pitch: float
    pitch_velocity: float
    clearance: float
    current: float
    grounded: bool


class Simulator:
    """A ship per metre of width in a current, stepped in time.

    It holds its own state and nothing else that changes: simulators that are given the same steps
    answer with the same bits, and `copy.copy` makes one that goes its own way from here.

    Parameters
    ----------
    reduced
        From `squat.reduced.load`, or made by `squat.reduced.reduce`.
    water
        Its density must be the model's.
    position
        Start: heave [m], or heave and pitch [rad]; the ship is at rest.
    current
        V at the start [m/s], not negative.
    body
        Mass and inertia per metre of width; None: the mass of the displaced water, with a radius
        of gyration of a quarter of the length about the pitch centre.
    max_step
        Longest step of the integrator [s]; longer ones are cut into equal parts.
    """

    def __init__(
        self,
        reduced: Loaded,
        water: Water,
        position: ArrayLike,
        current: float,
        body: RigidBody | None = None,
        max_step: float = 0.1,
    ) -> None:
        q = np.array(position, float, ndmin=1)
        modes = reduced.model.modes
        if q.shape != (len(modes),):
            raise InputError(f"position={position!r}: give {', '.join(modes)}")
        if not max_step > 0:
            raise InputError(f"max_step={max_step}: must be positive")
        self._max_step, self._speed = max_step, _checked(current)
        self._motion = _motion(reduced, water, body)
        self._phase = self._motion.at_rest(q)
        self._force = self._motion.force(0.0)
        self._place = self._motion.place(self._phase)
        self._state = State(0.0, *self._place, current=self._speed, grounded=False)

    @staticmethod
    def load(path: Path | str, position: ArrayLike, current: float, **options: Any) -> "Simulator":
        """From a file of `squat task=reduced`, under g = 9.81 m/s2; `options` as above."""
        reduced = load(Path(path))
        water = Water(density=reduced.model.density, gravity=9.81)
        return Simulator(reduced, water, position, current, **options)

    @property
    def state(self) -> State:
        """The ship now."""
        return self._state

    def step(self, dt: float, current: float, external_force: ArrayLike = 0.0) -> State:
        """Go on by `dt` [s] and return the ship at the end.

        Parameters
        ----------
        current
            V [m/s] at the end of the step: linear from its last value, its rate acts by -b dV/dt.
        external_force
            Generalised force per metre of width at the end of the step, linear from its last value:
            N/m in heave, positive up, and N in pitch, positive bow down.

        Raises
        ------
        InputError
            Where an argument is not finite, dt not positive, or the current negative.
        PositionError
            Where the ship leaves the model's box, but for the bottom; it is where it was before.
        """
        if not 0 < dt < math.inf:
            raise InputError(f"dt={dt}: must be positive and finite")
        force, speed = self._motion.force(external_force), _checked(current)
        rate = (speed - self._speed) / dt
        start, end = Drive(self._speed, rate, self._force), Drive(speed, rate, force)
        phase, place, grounded = self._phase, self._place, True
        if not self._state.grounded:
            phase, place, grounded = self._march(dt, start, end)
        self._speed, self._force, self._phase, self._place = speed, force, phase, place
        if grounded:
            place = place._replace(heave_velocity=0.0, pitch_velocity=0.0)
        self._state = State(self._state.time + dt, *place, speed, grounded)
        return self._state

    def _march(self, dt: float, start: Drive, end: Drive) -> tuple[Any, Place, bool]:
        """Phase and place after `dt`, or the last ones before the bottom; whether that was met."""
        parts = math.ceil(dt / self._max_step)
        marks = [start, *(start.towards(end, i / parts) for i in range(1, parts)), end]
        phase, place = self._phase, self._place
        for one, other in pairwise(marks):
            try:
                after = self._motion.advance(phase, dt / parts, one, other)
                phase, place = after, self._motion.place(after)
            except GroundedError:
                return phase, place, True
        return phase, place, False


def _motion(reduced: Loaded, water: Water, body: RigidBody | None) -> Motion:
    model = reduced.model
    if water.density != model.density:
        raise InputError(
            f"water.density={water.density:g}: the reduced model was made with "
            f"{model.density:g}; make it again"
        )
    still = still_water(model.submesh, water)
    if body is None:
        mass = water.density * still.rest[1]
        body = RigidBody(model.modes, mass, mass * (still.length / 4) ** 2, water.gravity)
    ship = ShipEnergy(body, still, model, 0.0)
    if len(model.modes) > 1:
        return ManyModes(ship, model)
    clearance = model.submesh.limits.clearance
    low, high = model.box.bounds
    curves = Curves.of(reduced.fluid(water, 0.0), low - clearance, high - clearance, _POINTS)
    return HeaveAlone(ship, HeaveTable(curves))


def _checked(current: float) -> float:
    if not 0 <= current < math.inf:
        raise InputError(f"current={current}: must be finite and not negative")
    return float(current)
