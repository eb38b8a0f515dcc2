"""The ship in the water as a problem for the coupling loop."""

from dataclasses import dataclass

import numpy as np

from squat.coupling import Load
from squat.dynamics import Motion, RigidBody
from squat.fluid.model import Flow, FluidModel
from squat.fluid.rates import Levels, Rate
from squat.mesh import PositionError
from squat.quantities import Vector


@dataclass(frozen=True)
class ShipProblem:
    """M_s q'' = weight + pressure force, Eqs. (14) and (15): a `coupling.Problem`."""

    body: RigidBody
    fluid: FluidModel
    rate: Rate

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
        force = self.fluid.force(flow, rate) + self.body.weight
        return Load(force, Levels(flow.potential, memory.now, rate))

    def steady(self, position: Vector) -> tuple[Flow, Vector]:
        """Flow past the ship at rest, and the net force on it, shape (n,)."""
        flow = self.fluid.flow(position, np.zeros_like(position))
        still = np.zeros_like(flow.potential)
        return flow, self.fluid.force(flow, still) + self.body.weight

    def at_rest(self, position: Vector) -> tuple[Motion, Levels]:
        """Start "at rest": no velocity, no acceleration, steady flow."""
        flow, _ = self.steady(position)
        zero = np.zeros_like(position)
        levels = Levels(flow.potential, flow.potential, np.zeros_like(flow.potential))
        return Motion(position, zero, zero), levels

    def balanced(self, position: Vector, dt: float) -> tuple[Motion, Levels]:
        """Start released: (M_s + c) q'' = net steady force; the potential's rate follows q''."""
        flow, net = self.steady(position)
        inertia = self.body.matrix + self.fluid.coefficients(position).c
        acceleration = np.asarray(np.linalg.solve(inertia, net), float)
        rate = acceleration @ self.fluid.unit_potentials(position)[1]
        before = flow.potential - dt * rate
        return Motion(position, np.zeros_like(position), acceleration), Levels(
            flow.potential, before, rate
        )
