"""What a run needs before it starts, put together: energies, coupling, loop."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from squat.coupling import (
    PREDICTORS,
    Conserving,
    Coupling,
    Measured,
    Modes,
    Scheme,
    SingleMode,
    State,
    Step,
    corrected,
    standard,
)
from squat.dynamics import Motion, RigidBody
from squat.dynamics.energy_momentum import rounding_of
from squat.errors import InputError
from squat.fluid.curves import POINTS, Curves
from squat.fluid.energy import ShipEnergy, still_water
from squat.fluid.heave import HeaveEnergy
from squat.fluid.model import EnergyModel, FluidModel, forget
from squat.fluid.potential import PotentialFluid
from squat.fluid.rates import RATES, Rate
from squat.fluid.ship import check_stability, rigid_body
from squat.mesh import GroundedError, PositionError, Submesh
from squat.quantities import Vector
from squat.reduced.heave import HeaveFluid
from squat.reduced.hull import HullFluid
from squat.transient.case import TransientCase
from squat.transient.inputs import Water, load_added_mass, load_fluid
from squat.transient.problem import EnergyProblem, Field, ShipProblem

_FINE = 32
"""Positions that curves of a reduced model are made from: it answers at once."""
_ROUNDING = 1e-12


@dataclass(frozen=True)
class Parts:
    """The pieces of one run; `added_mass` is m_add (n, n) of (23) at q = 0.

    `loop` is the problem as the coupling loop sees it; states, kept and recorded, are the ship's.
    `field` gives the potential after the run, from the motion alone; None where the states hold
    it, or nothing does.
    """

    problem: ShipProblem | EnergyProblem
    loop: Measured
    fluid: Water
    field: Field | None
    coupling: Coupling | Conserving
    added_mass: Vector
    omega: float
    dt: float

    def forget(self) -> None:
        """Let the flow solvers answer as new ones would."""
        forget(self.problem.model)
        forget(self.fluid)

    def advance(self, state: State) -> Step:
        """One time step; diverged where it leaves the positions that the model can take."""
        if isinstance(self.coupling, Coupling):
            return self.loop.advanced(self.coupling, state, self.dt)
        try:
            return self.coupling.advance(state, self.dt)
        except PositionError:
            unknown = np.full(len(self.added_mass), np.nan)
            return Step("diverged", state, unknown[:1], np.nan, unknown)


def prepare(case: TransientCase) -> Parts:
    """Mesh, added mass and loop of `case`, from its input files where given."""
    fluid = load_fluid(case)
    check_stability(fluid.mesh.submesh, _body(case), case.water)
    _check_start(case, fluid.mesh.submesh)
    problem = _problem(case, fluid)
    added = load_added_mass(case)
    omega = case.omega(float(added[case.place, case.place]))
    loop = _measured(case, problem)
    coupling = _coupling(case, problem, loop, added)
    field = Field(fluid, _rate(case)) if case.model == "reduced" else None
    return Parts(problem, loop, fluid, field, coupling, added, omega, case.time.step(omega))


def _check_start(case: TransientCase, submesh: Submesh) -> None:
    """Raise InputError where the ship cannot be set free."""
    q, _ = case.start
    try:
        submesh.check(q)
    except GroundedError:
        pass  # of what the mesh can follow, which is closer to the bottom than what a run may
    except PositionError as error:
        raise error.of("initial_") from error
    gap, rest = submesh.clearance(q), submesh.limits.clearance
    if gap < case.grounding * rest * (1 - _ROUNDING):
        given = zip(case.modes, q.tolist(), strict=True)
        start = " ".join(f"initial_{mode}={value:g}" for mode, value in given)
        least = f"grounding={case.grounding:g} of {rest:.4g} m at rest"
        raise InputError(f"{start}: grounded, clearance {gap:.4g} m is less than {least}")


def _body(case: TransientCase) -> RigidBody:
    return rigid_body(case.hull, case.water, case.modes, case.mooring)


def _measured(case: TransientCase, problem: ShipProblem | EnergyProblem) -> Measured:
    """`problem` as the coupling loop sees it: all coordinates in metres."""
    half = case.hull.outline.length / 2
    lengths = [half if mode == "pitch" else 1.0 for mode in case.modes]
    return Measured(problem, np.array(lengths), problem.free)


def ship_energy(case: TransientCase, fluid: Water, model: EnergyModel) -> ShipEnergy:
    """Energy of ship and water, the water's by `model`."""
    still = still_water(fluid.mesh.submesh, case.water)
    return ShipEnergy(_body(case), still, model, case.current)


def curves(case: TransientCase, fluid: Water, lowest: float = np.inf) -> Curves:
    """Energy coefficients on the run's mesh, down to half the grounding or to `lowest` [m]."""
    forget(fluid)  # a restarted run has not asked what an undisturbed one has
    limits = fluid.mesh.submesh.limits
    low = min((case.grounding / 2 - 1) * limits.clearance, lowest)
    low = max(low, (limits.fraction - 1) * limits.clearance)
    points = _FINE if case.model == "reduced" else POINTS
    return Curves.of(fluid, low, min(limits.draft / 2, limits.wall * 0.9), points)


def _problem(case: TransientCase, fluid: Water) -> ShipProblem | EnergyProblem:
    free = np.array([mode not in case.held for mode in case.modes])
    if case.force == "pressure":
        return ShipProblem(_body(case), _pressed(fluid), _rate(case), free)
    several = len(case.modes) > 1
    model = fluid if several or case.model == "full" else curves(case, fluid)
    field = Field(fluid, _rate(case)) if case.model == "full" else None
    return EnergyProblem(ship_energy(case, fluid, model), field, free)


def _pressed(fluid: Water) -> FluidModel:
    """The same water for pressure forces: the reduced one without its nodes."""
    if isinstance(fluid, PotentialFluid):
        return fluid
    return HeaveFluid.of(fluid) if fluid.model.modes == ("heave",) else HullFluid.of(fluid)


def _rate(case: TransientCase) -> Rate:
    return RATES[case.coupling.potential_rate]


def _coupling(
    case: TransientCase,
    problem: ShipProblem | EnergyProblem,
    loop: Measured,
    added_mass: Vector,
) -> Coupling | Conserving:
    choice = case.coupling
    if choice.conserving:
        assert isinstance(problem, EnergyProblem)  # TransientCase refuses others
        energy = problem.energy
        whole: Modes | SingleMode
        if isinstance(energy.model, Curves):
            whole = SingleMode(HeaveEnergy(energy))
        else:
            known = rounding_of(energy, case.start[0], energy.lengths)
            whole = Modes(energy, energy.lengths, known)
        return Conserving.of(whole, choice.criterion, problem.remember)
    return Coupling(
        _scheme(case, loop, problem.model, added_mass),
        choice.ties,
        choice.accelerator,
        PREDICTORS[choice.predictor],
        choice.criterion,
    )


def _scheme(
    case: TransientCase, loop: Measured, model: FluidModel | EnergyModel, added_mass: Vector
) -> Callable[[Motion], Scheme]:
    """The structure solve that follows a motion, see `CouplingChoice.scheme`."""
    if case.coupling.scheme == "consistent":
        beta = case.coupling.beta(case.force)

        def following(motion: Motion) -> Scheme:
            inertia = model.coefficients(loop.inward(motion).position).c
            return corrected(loop.mass, loop.matrix(beta * inertia))

        return following
    fixed = corrected(loop.mass, loop.matrix(added_mass))
    if case.coupling.scheme == "standard":
        fixed = standard(loop.mass)
    return lambda motion: fixed
