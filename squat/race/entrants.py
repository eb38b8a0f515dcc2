"""What is raced: three problems that differ in where inertia and stiffness sit."""

from dataclasses import dataclass
from typing import Any, Protocol

from squat.coupling import Load, State
from squat.dynamics import Integrator, Motion
from squat.piston.piston import Oscillator, Piston
from squat.quantities import Vector
from squat.water import Water


class Entrant(Protocol):
    """A problem of one degree of freedom, and what theory says of its iteration."""

    @property
    def mass(self) -> Vector:
        """Structural mass, shape (1, 1)."""
        ...

    @property
    def omega(self) -> float:
        """Angular frequency of the coupled linear oscillation [rad/s]."""
        ...

    @property
    def displacement(self) -> float:
        """Initial displacement [m]."""
        ...

    @property
    def paper(self) -> float:
        """m_add that the paper would take."""
        ...

    def load(self, trial: Motion, memory: Any, dt: float) -> Load:
        """See `Problem`."""
        ...

    def begin(self, dt: float) -> State:
        """State at t = 0."""
        ...

    def inertia(self, position: Vector, integrator: Integrator) -> float:
        """What an iteration feeds back of the water's inertia: beta c."""
        ...

    def tangent(self, integrator: Integrator, dt: float) -> float:
        """What the structure solves implicitly, as a mass."""
        ...

    def fed_back(self, integrator: Integrator, dt: float) -> float:
        """All that an iteration feeds back at the start, as a mass: G = 0 for such an m_add."""
        ...


@dataclass(frozen=True)
class Column:
    """The piston of section 2; `sprung`: its stiffness is a spring's, solved with the structure.

    In the U-tube the difference of levels restores, so k belongs to the fluid; a piston on a spring
    in a level tube has the same coupled motion, with k in the structure.
    """

    oscillator: Oscillator
    displacement: float
    sprung: bool

    @staticmethod
    def of(piston: Piston, water: Water, *, sprung: bool) -> "Column":
        """Piston in `water`."""
        return Column(Oscillator.of(piston, water), piston.initial_position, sprung)

    @property
    def mass(self) -> Vector:
        """See `Entrant`."""
        return self.oscillator.mass

    @property
    def omega(self) -> float:
        """See `Entrant`."""
        return self.oscillator.omega

    @property
    def paper(self) -> float:
        """m_f, the paper's optimum [kg]."""
        return self.oscillator.fluid_mass

    def load(self, trial: Motion, memory: Any, dt: float) -> Load:
        """Water's inertia and stiffness, whoever has it."""
        return self.oscillator.load(trial, memory, dt)

    def begin(self, dt: float) -> State:
        """Released from rest."""
        return State((self.oscillator.start(self.displacement, 0.0),))

    def inertia(self, position: Vector, integrator: Integrator) -> float:
        """m_f: F takes the acceleration itself, beta = 1."""
        return self.oscillator.fluid_mass

    def _stiffness(self, integrator: Integrator, dt: float) -> float:
        return dt**2 / integrator.s3 * self.oscillator.stiffness

    def tangent(self, integrator: Integrator, dt: float) -> float:
        """(dt^2/s3) k of a spring."""
        return self._stiffness(integrator, dt) if self.sprung else 0.0

    def fed_back(self, integrator: Integrator, dt: float) -> float:
        """m_f, and (dt^2/s3) k where the water has it."""
        own = 0.0 if self.sprung else self._stiffness(integrator, dt)
        return self.oscillator.fluid_mass + own
