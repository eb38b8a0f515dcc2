"""The water in microseconds: a certified reduced basis on the affine form."""

from squat.reduced.bounds import Bounds, bounds
from squat.reduced.case import ReducedCase
from squat.reduced.fluid import ReducedFluid
from squat.reduced.greedy import Training, reduce
from squat.reduced.model import ReducedModel
from squat.reduced.record import load
from squat.reduced.run import run
from squat.reduced.simulator import Simulator, State

__all__ = [
    "Bounds",
    "ReducedCase",
    "ReducedFluid",
    "ReducedModel",
    "Simulator",
    "State",
    "Training",
    "bounds",
    "load",
    "reduce",
    "run",
]
