"""What the coupled run asks of a flow solver."""

from dataclasses import dataclass, field
from typing import Literal, NamedTuple, Protocol, runtime_checkable

from squat.errors import InputError
from squat.quantities import Vector

FreeSurface = Literal["rigid_lid", "zero_pressure", "blend"]


def check_current(free_surface: FreeSurface, current: float) -> None:
    """Raise InputError where no current reaches the hull."""
    if free_surface == "zero_pressure" and current != 0:
        raise InputError(
            f"free_surface=zero_pressure: no current={current:g} reaches the hull under "
            "it; give rigid_lid, blend, or current=0"
        )


class Flow(NamedTuple):
    """The flow of one trial motion: where, how fast, and the potential at the nodes (nodes,)."""

    position: Vector
    velocity: Vector
    potential: Vector


class Coefficients(NamedTuple):
    """Kinetic energy (V^2 a + 2 V b.q' + q'^T c q')/2 of the water per unit width.

    a [kg/m], b (n,) and c (n, n), the fluid's inertia under this free surface.
    """

    a: float
    b: Vector
    c: Vector


class Slopes(NamedTuple):
    """Derivatives of the energy coefficients by the coordinates q_k, k last.

    a (n,): da/dq_k; b (n, n): db_j/dq_k at [j, k]; c (n, n, n): dc_ij/dq_k at [i, j, k].
    """

    a: Vector
    b: Vector
    c: Vector


class EnergyModel(Protocol):
    """The water's kinetic energy as a function of the hull's position."""

    @property
    def free_surface(self) -> FreeSurface:
        """What the water's surface is taken for."""
        ...

    def coefficients(self, position: Vector) -> Coefficients:
        """Energy coefficients at `position`, shape (n,)."""
        ...

    def slopes(self, position: Vector) -> Slopes:
        """Their derivatives at `position`."""
        ...


@dataclass(frozen=True, eq=False)
class Noted:
    """An `EnergyModel` that notes what `model` answered, for several questions a position."""

    model: EnergyModel
    _coefficients: dict[bytes, Coefficients] = field(default_factory=dict, repr=False)
    _slopes: dict[bytes, Slopes] = field(default_factory=dict, repr=False)

    @property
    def free_surface(self) -> FreeSurface:
        """See `EnergyModel`."""
        return self.model.free_surface

    def coefficients(self, position: Vector) -> Coefficients:
        """See `EnergyModel`."""
        key = position.tobytes()
        if key not in self._coefficients:
            self._coefficients[key] = self.model.coefficients(position)
        return self._coefficients[key]

    def slopes(self, position: Vector) -> Slopes:
        """See `EnergyModel`."""
        key = position.tobytes()
        if key not in self._slopes:
            self._slopes[key] = self.model.slopes(position)
        return self._slopes[key]


class FluidModel(Protocol):
    """A flow solver for n rigid modes in a given current.

    `squat.fluid.potential.PotentialFluid` is the full one; anything else that answers these four
    questions couples to the ship in the same way.
    """

    @property
    def current(self) -> float:
        """V of the water far from the hull [m/s]."""
        ...

    def flow(self, position: Vector, velocity: Vector) -> Flow:
        """Flow for hull position and velocity, shape (n,) each; PositionError out of reach."""
        ...

    def force(self, flow: Flow, rate: Vector) -> Vector:
        """Generalised force (n,) of p - p_atm, given d phi/dt at the moving nodes."""
        ...

    def coefficients(self, position: Vector) -> Coefficients:
        """Energy coefficients at `position`."""
        ...

    def unit_potentials(self, position: Vector) -> tuple[Vector, Vector]:
        """phi_0 (nodes,) of unit current and phi_j (n, nodes) of unit velocities."""
        ...


@runtime_checkable
class Remembering(Protocol):
    """A model whose answers depend, within rounding, on what it was asked before."""

    def forget(self) -> None:
        """Answer from now on as a new object would."""
        ...


def forget(model: object) -> None:
    """Make `model` answer as a new one would; models without history need no method for it."""
    if isinstance(model, Remembering):
        model.forget()
