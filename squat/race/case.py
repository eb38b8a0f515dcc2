"""What the race is run over."""

from typing import Annotated, ClassVar

from pydantic import Field
from pydantic.dataclasses import dataclass

from squat.channel import AnyHull, Channel
from squat.coupling import Accelerator, Criterion, PredictorName
from squat.mesh import MeshSize
from squat.piston import Piston
from squat.quantities import STRICT, Count, Fraction, NonNegative, Position, Positive, Speed
from squat.water import Water

Ratios = Annotated[tuple[Positive, ...], Field(min_length=1)]
Contenders = Annotated[
    dict[str, Annotated[Accelerator, Field(discriminator="name")]], Field(min_length=1)
]


@dataclass(frozen=True, kw_only=True, config=STRICT)
class RaceCells:
    """The cells of the race.

    Parameters
    ----------
    mass_ratios
        Water's inertia over that of the structure: m_f/m, for the ship c(w(0))/m.
    steps_per_period
        Time steps in a period of the coupled oscillation.
    factors
        m_add over what the iteration feeds back, for the sweep of wrong added masses.
    factor_mass_ratio, factor_steps
        Mass ratio and steps a period of that sweep.
    """

    mass_ratios: Ratios
    steps_per_period: Annotated[tuple[Count, ...], Field(min_length=1)]
    factors: Annotated[tuple[NonNegative, ...], Field(min_length=1)]
    factor_mass_ratio: Positive
    factor_steps: Count


@dataclass(frozen=True, kw_only=True, config=STRICT)
class RaceCase:
    """Piston, sprung piston and ship, and the rules that all of them are run by.

    Parameters
    ----------
    piston
        Tube and initial position; its mass ratio is varied.
    hull, channel, water, mesh, current, initial_heave
        The ship, whose mass is varied at constant draft.
    accelerators
        The contenders by name.
    predictor
        Of every run.
    periods
        Length of every run in periods of its coupled oscillation.
    tolerance
        Of every step, over the initial displacement.
    iterations, growth
        See `Criterion`.
    """

    free_surface: ClassVar = "rigid_lid"

    piston: Piston
    hull: AnyHull
    channel: Channel
    water: Water
    mesh: MeshSize
    current: Speed
    initial_heave: Position
    cells: RaceCells
    accelerators: Contenders
    predictor: PredictorName
    periods: Positive
    tolerance: Fraction
    iterations: Count
    growth: Positive

    def criterion(self, displacement: float) -> Criterion:
        """Criterion of a run that starts `displacement` [m] from rest."""
        return Criterion(
            name="absolute",
            tolerance=self.tolerance * abs(displacement),
            iterations=self.iterations,
            growth=self.growth,
        )
