"""One run of the race: an entrant with one scheme, one accelerator, one time step."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Literal, NamedTuple, get_args

import numpy as np

from squat.coupling import PREDICTORS, Accelerator, Coupling, Monolithic, Scheme, corrected, march
from squat.dynamics import INTEGRATORS, IntegratorName, Motion
from squat.quantities import Vector
from squat.race.case import RaceCase
from squat.race.entrants import Entrant

SchemeLabel = Literal["standard", "corrected", "consistent"]
SCHEMES: tuple[SchemeLabel, ...] = get_args(SchemeLabel)


class Result(NamedTuple):
    """How a run went: mean iterations (NaN unless all steps converged), first contraction, status.

    `history` holds the positions after each accepted step [m].
    """

    mean: float
    contraction: float
    status: str
    history: Vector


@dataclass(frozen=True)
class Heat:
    """An entrant with an integrator and a number of steps a period."""

    case: RaceCase
    entrant: Entrant
    integrator: IntegratorName
    steps_per_period: int

    @property
    def dt(self) -> float:
        """Time step [s]."""
        return 2 * np.pi / self.entrant.omega / self.steps_per_period

    @property
    def steps(self) -> int:
        """Number of time steps."""
        return max(3, round(self.case.periods * self.steps_per_period))

    def added_mass(self, scheme: SchemeLabel) -> float:
        """m_add of the first step."""
        start = np.array([self.entrant.displacement])
        consistent = self.entrant.inertia(start, INTEGRATORS[self.integrator])
        masses = {"standard": 0.0, "corrected": self.entrant.paper, "consistent": consistent}
        return masses[scheme]

    def factor(self, added_mass: float) -> float:
        """Predicted G of the first step."""
        entrant, integrator = self.entrant, INTEGRATORS[self.integrator]
        total = float(entrant.mass[0, 0]) + entrant.tangent(integrator, self.dt) + added_mass
        return (added_mass - entrant.fed_back(integrator, self.dt)) / total

    def run(self, scheme: SchemeLabel, accelerator: Accelerator) -> Result:
        """Run with a named scheme."""
        if scheme == "consistent":
            integrator = INTEGRATORS[self.integrator]
            return self._run(
                lambda motion: self._solve(self.entrant.inertia(motion.position, integrator)),
                accelerator,
            )
        return self.run_with(self.added_mass(scheme), accelerator)

    def run_with(self, added_mass: float, accelerator: Accelerator) -> Result:
        """Run corrected with a constant m_add."""
        solve = self._solve(added_mass)
        return self._run(lambda motion: solve, accelerator)

    def reference(self) -> Result:
        """Structure and fluid solved together."""
        return self.run_with(0.0, Monolithic(name="monolithic"))

    def _solve(self, added_mass: float) -> Scheme:
        implicit = self.entrant.tangent(INTEGRATORS[self.integrator], self.dt)
        return corrected(self.entrant.mass, np.array([[added_mass + implicit]]))

    def _run(self, scheme: Callable[[Motion], Scheme], accelerator: Accelerator) -> Result:
        coupling = Coupling(
            scheme,
            INTEGRATORS[self.integrator],
            accelerator,
            PREDICTORS[self.case.predictor],
            self.case.criterion(self.entrant.displacement),
        )
        start = self.entrant.begin(self.dt)
        taken = list(march(self.entrant, coupling, start, self.dt, self.steps))
        status = taken[-1].status
        mean = float(np.mean([step.iterations for step in taken]))
        positions = [float(step.state.motion.position[0]) for step in taken]
        return Result(
            mean if status == "converged" else np.nan,
            taken[0].contraction,
            status,
            np.array(positions),
        )
