"""The ship in the water as a problem for the coupling loop, by its pressure or its energies."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from squat.coupling import Load
from squat.dynamics import Motion, RigidBody
from squat.dynamics.lagrangian import force
from squat.fluid.energy import ShipEnergy
from squat.fluid.model import EnergyModel, Flow, FluidModel
from squat.fluid.rates import Levels, Rate
from squat.mesh import PositionError
from squat.quantities import Vector


@dataclass(frozen=True)
class ShipProblem:
    """M_s q'' = weight + pressure force, Eqs. (14) and (15): a `coupling.Problem`.

    Modes that are not `free` (n,) do not accelerate when the ship is released.
    """

    body: RigidBody
    fluid: FluidModel
    rate: Rate
    free: NDArray[np.bool_]

    @property
    def model(self) -> FluidModel:
        """What knows the water's inertia."""
        return self.fluid

    @property
    def mass(self) -> Vector:
        """Structural mass matrix, shape (n, n)."""
        return self.body.matrix

    def load(self, trial: Motion, memory: Levels, dt: float) -> Load:
        """Force for a trial motion; not a number where the mesh cannot follow it."""
        try:
            flow = self.fluid.flow(trial.position, trial.velocity)
        except PositionError:
            return Load(np.full(len(trial.position), np.nan), memory)
        rate = self.rate(flow.potential, memory, dt)
        force = self.fluid.force(flow, rate) - self.body.gradient(trial.position)
        return Load(force, Levels(flow.potential, memory.now, rate))

    def water_force(self, motion: Motion, memory: Levels) -> Vector:
        """Force of the water (n,) in an accepted step."""
        flow = Flow(motion.position, motion.velocity, memory.now)
        return self.fluid.force(flow, memory.rate)

    def steady(self, position: Vector, velocity: Vector) -> tuple[Flow, Vector]:
        """Flow past the ship in steady motion, and the net force on it, shape (n,)."""
        flow = self.fluid.flow(position, velocity)
        still = np.zeros_like(flow.potential)
        return flow, self.fluid.force(flow, still) - self.body.gradient(position)

    def at_rest(self, position: Vector, velocity: Vector, dt: float) -> tuple[Motion, Levels]:
        """Start with q and q' (n,) as if so for ever: no acceleration, steady flow."""
        flow, _ = self.steady(position, velocity)
        levels = Levels(flow.potential, flow.potential, np.zeros_like(flow.potential))
        return Motion(position, velocity, np.zeros_like(position)), levels

    def balanced(self, position: Vector, velocity: Vector, dt: float) -> tuple[Motion, Levels]:
        """Start released: (M_s + c) q'' = net steady force; the potential's rate follows q''."""
        flow, net = self.steady(position, velocity)
        inertia = self.body.matrix + self.fluid.coefficients(position).c
        acceleration = released(inertia, net, self.free)
        rate = acceleration @ self.fluid.unit_potentials(position)[1]
        before = flow.potential - dt * rate
        return Motion(position, velocity, acceleration), Levels(flow.potential, before, rate)


def released(inertia: Vector, force: Vector, free: NDArray[np.bool_]) -> Vector:
    """Acceleration (n,) of the free modes under `force` (n,), the others held."""
    out = np.zeros_like(force)
    out[free] = np.linalg.solve(inertia[np.ix_(free, free)], force[free])
    return out


@dataclass(frozen=True)
class Field:
    """The potential of a run whose force does not need it: for pressure and snapshots."""

    fluid: FluidModel
    rate: Rate

    def start(self, motion: Motion, dt: float) -> Levels:
        """Levels at t = 0: the rate follows q'', the level before it the rate."""
        potential = self._potential(motion)
        rate = motion.acceleration @ self.fluid.unit_potentials(motion.position)[1]
        return Levels(potential, potential - dt * rate, rate)

    def levels(self, motion: Motion, memory: Levels | None, dt: float) -> Levels:
        """Levels after the step that follows `memory`, or at t = 0 where there is none."""
        return self.start(motion, dt) if memory is None else self.follow(motion, memory, dt)

    def follow(self, motion: Motion, memory: Levels, dt: float) -> Levels:
        """Levels after one more step."""
        potential = self._potential(motion)
        return Levels(potential, memory.now, self.rate(potential, memory, dt))

    def _potential(self, motion: Motion) -> Vector:
        current, unit = self.fluid.unit_potentials(motion.position)
        return np.asarray(self.fluid.current * current + motion.velocity @ unit)


@dataclass(frozen=True)
class EnergyProblem:
    """M_s q'' = weight + variational force: a `coupling.Problem`.

    Parameters
    ----------
    energy
        Of ship and water.
    field
        What the potential is kept by; None where the model has none.
    free
        See `ShipProblem`.
    """

    energy: ShipEnergy
    field: Field | None
    free: NDArray[np.bool_]

    @property
    def body(self) -> RigidBody:
        """Mass matrix, weight and mooring."""
        return self.energy.body

    @property
    def model(self) -> EnergyModel:
        """What knows the water's inertia."""
        return self.energy.model

    @property
    def mass(self) -> Vector:
        """Structural mass matrix, shape (n, n)."""
        return self.energy.body.matrix

    def load(self, trial: Motion, memory: Levels | None, dt: float) -> Load:
        """Force for a trial motion; not a number where the model cannot follow it."""
        try:
            found = force(self.energy, trial, self.mass)
        except PositionError:
            return Load(np.full(len(trial.position), np.nan), memory)
        return Load(found, self.remember(trial, memory, dt))

    def remember(self, motion: Motion, memory: Levels | None, dt: float) -> Levels | None:
        """What is kept of an accepted step."""
        if self.field is None or memory is None:
            return None
        return self.field.follow(motion, memory, dt)

    def water_force(self, motion: Motion, memory: Levels | None) -> Vector:
        """Force of the water (n,) in an accepted step."""
        return self.energy.water_force(motion)

    def at_rest(
        self, position: Vector, velocity: Vector, dt: float
    ) -> tuple[Motion, Levels | None]:
        """Start with q and q' (n,) as if so for ever: no acceleration."""
        return self._start(Motion(position, velocity, np.zeros_like(position)), dt)

    def balanced(
        self, position: Vector, velocity: Vector, dt: float
    ) -> tuple[Motion, Levels | None]:
        """Start released, in balance with the inertia of ship and water."""
        zero = np.zeros_like(position)
        net = force(self.energy, Motion(position, velocity, zero), np.zeros_like(self.mass))
        acceleration = released(self.energy.mass(position), net, self.free)
        return self._start(Motion(position, velocity, acceleration), dt)

    def _start(self, motion: Motion, dt: float) -> tuple[Motion, Levels | None]:
        return motion, None if self.field is None else self.field.start(motion, dt)
