"""A structure and a force that is known by its answers, as a problem for the loop."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from squat.coupling import Load
from squat.dynamics import Motion
from squat.errors import InputError
from squat.external.structure import StructureModel
from squat.quantities import Vector

Fluid = Callable[[Motion, float, Any], "ArrayLike | Load"]


class Progress(NamedTuple):
    """Steps accepted so far, and what the fluid remembers of the last."""

    steps: int
    fluid: Any


@dataclass(frozen=True)
class BlackBox:
    """A structure and a fluid known by its answers: a `coupling.Problem`."""

    structure: StructureModel
    fluid: Fluid

    @property
    def mass(self) -> Vector:
        """Structural mass matrix, shape (n, n)."""
        return self.structure.mass

    def load(self, trial: Motion, memory: Progress, dt: float) -> Load:
        """Force of structure and fluid at the end of the step that follows `memory`."""
        time = (memory.steps + 1) * dt
        given = self.fluid(trial, time, memory.fluid)
        answer, kept = given if isinstance(given, Load) else (given, None)
        name = getattr(self.fluid, "__name__", type(self.fluid).__name__)
        if answer is None:
            raise InputError(f"fluid={name}: answered None; return the force")
        try:
            force = np.atleast_1d(np.asarray(answer, float))
        except (TypeError, ValueError):
            kind = type(answer).__name__
            raise InputError(
                f"fluid={name}: answered a {kind} that is no force; return numbers, or "
                "squat.Load(force, memory)"
            ) from None
        if force.shape != trial.position.shape:
            raise InputError(
                f"fluid: answered a force of shape {force.shape}; "
                f"give one of {trial.position.shape}"
            )
        return Load(self.structure.force(trial, time) + force, Progress(memory.steps + 1, kept))
