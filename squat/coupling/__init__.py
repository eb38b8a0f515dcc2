"""Partitioned coupling of a structure with a fluid: one loop, independent slots."""

from squat.coupling.accelerators import Accelerator, Aitken, ConstantRelaxation, NoAcceleration
from squat.coupling.conserving import Conserving, Modes, SingleMode
from squat.coupling.criteria import Criterion
from squat.coupling.loop import Coupling, State, Status, Step, advance, march, repeated
from squat.coupling.measured import Measured
from squat.coupling.monolithic import Monolithic
from squat.coupling.predictors import PREDICTORS, Predictor, PredictorName
from squat.coupling.problem import Load, Problem
from squat.coupling.quasi_newton import Anderson, InterfaceQuasiNewton, Secants
from squat.coupling.schemes import Scheme, SchemeName, corrected, standard

__all__ = [
    "PREDICTORS",
    "Accelerator",
    "Aitken",
    "Anderson",
    "Conserving",
    "ConstantRelaxation",
    "Coupling",
    "Criterion",
    "InterfaceQuasiNewton",
    "Load",
    "Measured",
    "Modes",
    "Monolithic",
    "NoAcceleration",
    "Predictor",
    "PredictorName",
    "Problem",
    "Scheme",
    "SchemeName",
    "Secants",
    "SingleMode",
    "State",
    "Status",
    "Step",
    "advance",
    "corrected",
    "march",
    "repeated",
    "standard",
]
