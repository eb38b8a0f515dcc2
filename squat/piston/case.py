"""One piston run as a whole: what to solve, and how."""

from typing import Annotated

import numpy as np
from pydantic import Field
from pydantic.dataclasses import dataclass

from squat.coupling import (
    PREDICTORS,
    Accelerator,
    Conserving,
    Coupling,
    Criterion,
    PredictorName,
    SchemeName,
    SingleMode,
    corrected,
    standard,
)
from squat.coupling.amplification import amplification_factor
from squat.dynamics import INTEGRATORS, StepName, TimeGrid
from squat.piston.piston import Oscillator, Piston
from squat.quantities import STRICT
from squat.water import Water


@dataclass(frozen=True, kw_only=True, config=STRICT)
class PistonCase:
    """A piston, its water, its time steps, and the four slots of the coupling loop.

    `integrator=energy_momentum` steps piston and water as one system and uses of the slots only
    the criterion's limits.
    """

    piston: Piston
    water: Water
    time: TimeGrid
    scheme: SchemeName
    integrator: StepName
    accelerator: Annotated[Accelerator, Field(discriminator="name")]
    predictor: PredictorName
    criterion: Criterion

    @property
    def oscillator(self) -> Oscillator:
        """The problem in numbers."""
        return Oscillator.of(self.piston, self.water)

    @property
    def dt(self) -> float:
        """Time step [s]."""
        return self.time.step(self.oscillator.omega)

    @property
    def added_mass(self) -> float:
        """m_add [kg] of the scheme: 0 standard, m_f consistent."""
        ratios = {"standard": 0.0, "corrected": self.piston.added_mass_ratio, "consistent": 1.0}
        return ratios[self.scheme] * self.oscillator.fluid_mass

    def amplification(self) -> float:
        """G in closed form; of the sweeps of `energy_momentum` -(omega dt)^2/4."""
        problem = self.oscillator
        if self.integrator == "energy_momentum":
            return -((problem.omega * self.dt) ** 2) / 4
        return float(
            amplification_factor(
                problem.piston_mass,
                problem.fluid_mass,
                problem.stiffness,
                self.dt,
                INTEGRATORS[self.integrator],
                self.added_mass,
            )
        )

    def coupling(self) -> Coupling | Conserving:
        """The loop's slots, or piston and water as one system."""
        if self.integrator == "energy_momentum":
            return Conserving.of(SingleMode(self.oscillator), self.criterion)
        mass = self.oscillator.mass
        m_add = np.array([[self.added_mass]])
        scheme = standard(mass) if self.scheme == "standard" else corrected(mass, m_add)
        return Coupling(
            lambda motion: scheme,
            INTEGRATORS[self.integrator],
            self.accelerator,
            PREDICTORS[self.predictor],
            self.criterion,
        )
