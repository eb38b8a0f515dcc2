"""Motion of a rigid body in time: what it is, and how it is discretised."""

from squat.dynamics.body import RigidBody
from squat.dynamics.integrators import INTEGRATORS, Integrator, IntegratorName, Kinematics, StepName
from squat.dynamics.motion import Motion
from squat.dynamics.time import TimeGrid

__all__ = [
    "INTEGRATORS",
    "Integrator",
    "IntegratorName",
    "Kinematics",
    "Motion",
    "RigidBody",
    "StepName",
    "TimeGrid",
]
