"""Groups of a coupled run's keys: how to couple, what to start from, when to end and go on."""

from typing import Annotated, Literal

from pydantic import Field
from pydantic.dataclasses import dataclass

from squat.coupling import Accelerator, Criterion, PredictorName, SchemeName
from squat.dynamics import INTEGRATORS, Integrator, StepName, TimeGrid
from squat.fluid.rates import RATES, RateName
from squat.quantities import STRICT, NonNegative

Force = Literal["pressure", "variational"]


@dataclass(frozen=True, kw_only=True, config=STRICT)
class CouplingChoice:
    """A named set of the loop's slots (`conf/coupling/`).

    Parameters
    ----------
    name
        What the record calls it.
    scheme
        `standard`; `corrected` with m_add of Eq. (23) at w = 0; `consistent` with
        m_add = beta c(w^n), c of the fluid that the run couples to, refreshed in every step.
    integrator
        Form of w' and w'', see squat/dynamics/integrators.py; `energy_momentum` steps ship and
        water as one system (squat/dynamics/energy_momentum.py) and takes of the other slots only
        the criterion's limits.
    potential_rate
        Form of d phi/dt at a node, see squat/fluid/rates.py.
    start
        `rest`: no acceleration before t = 0; `balanced`: released in balance with its inertia.
    """

    name: str
    scheme: SchemeName
    integrator: StepName
    potential_rate: RateName
    predictor: PredictorName
    accelerator: Annotated[Accelerator, Field(discriminator="name")]
    criterion: Criterion
    start: Literal["rest", "balanced"]

    @property
    def conserving(self) -> bool:
        """Whether ship and water are stepped as one system."""
        return self.integrator == "energy_momentum"

    @property
    def ties(self) -> Integrator:
        """The loop's integrator; there is none where `conserving`."""
        assert self.integrator != "energy_momentum"
        return INTEGRATORS[self.integrator]

    def beta(self, force: Force) -> float:
        """Share of the water's inertia c that one iteration feeds back.

        s1 s2/s3 where the pressure holds d phi/dt; all of it where the force holds -c q'' itself.
        """
        if force == "variational":
            return 1.0
        return self.ties.s1 * RATES[self.potential_rate].s2 / self.ties.s3


@dataclass(frozen=True, kw_only=True, config=STRICT)
class Inputs:
    """Files of earlier tasks; None: the run makes what it lacks.

    Parameters
    ----------
    mesh
        Dataset of task=mesh for the same hull, channel and mesh.
    added_mass
        Dataset of task=added_mass under zero pressure for the same hull and channel.
    equilibria
        Dataset of task=equilibria, for the roots drawn beside the run.
    reduced
        Dataset of task=reduced for the same hull, channel, water, mesh and free surface; for
        snapshots one with fields=true.
    """

    mesh: str | None
    added_mass: str | None
    equilibria: str | None
    reduced: str | None


@dataclass(frozen=True, kw_only=True, config=STRICT)
class Duration(TimeGrid):
    """When a run ends, if it does not end early.

    Parameters
    ----------
    until
        `end`: after `periods`. `turn`: at the first turning point too, the first step in which
        the ship moves against the direction that it set out in.
    """

    until: Literal["end", "turn"]


@dataclass(frozen=True, kw_only=True, config=STRICT)
class Restart:
    """Where a run that was killed goes on when it is started again.

    Parameters
    ----------
    interval
        Steps between two points at which it can go on; 0: none. At each of them the flow solver
        forgets its factor and start vectors, killed or not, so that the bytes are the same.
    pause
        Least wall time between writing two of them [s].
    """

    interval: Annotated[int, Field(strict=True, ge=0)]
    pause: NonNegative
