"""What a run needs before it starts: mesh, added mass, loop."""

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import NamedTuple

import numpy as np
import xarray as xr

from squat import records
from squat.coupling import (
    PREDICTORS,
    Conserving,
    Coupling,
    Modes,
    Scheme,
    SingleMode,
    State,
    Step,
    advance,
    corrected,
    standard,
)
from squat.dynamics import Motion, RigidBody
from squat.errors import InputError
from squat.fluid.accuracy import accurate
from squat.fluid.curves import POINTS, Curves
from squat.fluid.energy import ShipEnergy, still_water
from squat.fluid.heave import HeaveEnergy
from squat.fluid.model import EnergyModel, FluidModel, forget
from squat.fluid.potential import PotentialFluid
from squat.fluid.rates import RATES
from squat.mesh import Mesh, PositionError, submesh
from squat.mesh.generate import generate
from squat.mesh.ugrid import from_dataset
from squat.quantities import Vector
from squat.records.kinds import ADDED_MASS, EQUILIBRIA, MESH, REDUCED
from squat.records.schema import Kind
from squat.reduced.fluid import ReducedFluid
from squat.reduced.greedy import reduce
from squat.reduced.record import Loaded, load, on_patch
from squat.stability.equilibria import OneDimensionalModel
from squat.transient.case import TransientCase
from squat.transient.problem import EnergyProblem, Field, ShipProblem

MODES = ("heave",)
_FINE = 32
"""Positions that curves of a reduced model are made from: it answers at once."""
Water = PotentialFluid | ReducedFluid
"""Flow solvers with pressure and field."""


@dataclass(frozen=True)
class Parts:
    """The pieces of one run; `added_mass` is m_add [kg/m] of (23) at w = 0."""

    problem: ShipProblem | EnergyProblem
    fluid: Water
    coupling: Coupling | Conserving
    added_mass: float
    omega: float
    dt: float

    def forget(self) -> None:
        """Let the flow solvers answer as new ones would."""
        forget(self.problem.model)
        forget(self.fluid)

    def advance(self, state: State) -> Step:
        """One time step; diverged where it leaves the positions that the model can take."""
        if isinstance(self.coupling, Coupling):
            return advance(self.problem, self.coupling, state, self.dt)
        try:
            return self.coupling.advance(state, self.dt)
        except PositionError:
            unknown = np.array([np.nan])
            return Step("diverged", state, unknown, np.nan, unknown)


def prepare(case: TransientCase) -> Parts:
    """Mesh, added mass and loop of `case`, from its input files where given."""
    fluid = load_fluid(case)
    problem = _problem(case, fluid)
    added = load_added_mass(case)
    omega = case.omega(added)
    coupling = _coupling(case, problem, added)
    return Parts(problem, fluid, coupling, added, omega, case.time.step(omega))


def load_fluid(case: TransientCase) -> Water:
    """The flow solver: on the whole mesh, or a reduced one where `case.model` says so."""
    if case.model != "reduced":
        return PotentialFluid(load_mesh(case), case.water, case.free_surface, case.current)
    return load_reduced(case).fluid(case.water, case.current)


def load_reduced(case: TransientCase) -> Loaded:
    """The reduced model of the input file, or a new one; the whole mesh where snapshots need it."""
    if case.inputs.reduced is not None:
        same = ("hull", "channel", "water", "mesh", "free_surface")
        _input(case.inputs.reduced, REDUCED, case, same)
        return load(Path(case.inputs.reduced), fields=case.snapshots > 0)
    mesh = load_mesh(case)
    made = reduce(mesh, case.water.density, case.free_surface, case.reduced)
    return Loaded(made.model, mesh, made.basis) if case.snapshots else on_patch(made, mesh)


def ship_energy(case: TransientCase, fluid: Water, model: EnergyModel) -> ShipEnergy:
    """Energy of ship and water, the water's by `model`."""
    body = RigidBody(MODES, case.mass, 0.0, case.water.gravity)
    return ShipEnergy(body, still_water(fluid.mesh.submesh, case.water), model, case.current)


def curves(case: TransientCase, fluid: Water, lowest: float = np.inf) -> Curves:
    """Energy coefficients on the run's mesh, down to half the grounding or to `lowest` [m]."""
    forget(fluid)  # a restarted run has not asked what an undisturbed one has
    limits = fluid.mesh.submesh.limits
    low = min((case.grounding / 2 - 1) * limits.clearance, lowest)
    low = max(low, (limits.fraction - 1) * limits.clearance)
    points = _FINE if case.model == "reduced" else POINTS
    return Curves.of(fluid, low, min(limits.draft / 2, limits.wall * 0.9), points)


def _problem(case: TransientCase, fluid: Water) -> ShipProblem | EnergyProblem:
    rate = RATES[case.coupling.potential_rate]
    if case.force == "pressure":
        body = RigidBody(MODES, case.mass, 0.0, case.water.gravity)
        return ShipProblem(body, fluid, rate)
    model = fluid if case.model == "full" else curves(case, fluid)
    field = None if case.model == "curves" else Field(fluid, rate)
    return EnergyProblem(ship_energy(case, fluid, model), field)


def _coupling(
    case: TransientCase,
    problem: ShipProblem | EnergyProblem,
    added_mass: float,
) -> Coupling | Conserving:
    choice = case.coupling
    if choice.conserving:
        assert isinstance(problem, EnergyProblem)  # TransientCase refuses others
        energy = problem.energy
        whole: Modes | SingleMode = Modes(energy, energy.lengths)
        if isinstance(energy.model, Curves):
            whole = SingleMode(HeaveEnergy(energy))
        return Conserving.of(whole, choice.criterion, problem.remember)
    return Coupling(
        _scheme(case, problem.mass, problem.model, added_mass),
        choice.ties,
        choice.accelerator,
        PREDICTORS[choice.predictor],
        choice.criterion,
    )


def _scheme(
    case: TransientCase, mass: Vector, model: FluidModel | EnergyModel, added_mass: float
) -> Callable[[Motion], Scheme]:
    """The structure solve that follows a motion, see `CouplingChoice.scheme`."""
    if case.coupling.scheme == "consistent":
        beta = case.coupling.beta(case.force)
        return lambda motion: corrected(mass, beta * model.coefficients(motion.position).c)
    fixed = corrected(mass, np.array([[added_mass]]))
    if case.coupling.scheme == "standard":
        fixed = standard(mass)
    return lambda motion: fixed


def load_mesh(case: TransientCase) -> Mesh:
    """The mesh of the input file, or a new one."""
    if case.inputs.mesh is None:
        return generate(submesh(case.hull, case.channel, MODES), case.mesh)
    data = _input(case.inputs.mesh, MESH, case, ("hull", "channel", "mesh"))
    return from_dataset(data, MODES)


def load_added_mass(case: TransientCase) -> float:
    """Heave added mass [kg/m] of Eq. (23) at w = 0, extrapolated."""
    if case.inputs.added_mass is None:
        value, _ = accurate(case.hull, case.channel, case.accuracy, "zero_pressure")
        return case.water.density * float(value[1, 1])
    data = _input(case.inputs.added_mass, ADDED_MASS, case, ("hull", "channel", "water"))
    if data.attrs["free_surface"] != "zero_pressure":
        raise InputError(
            f"inputs.added_mass={case.inputs.added_mass}: computed with free_surface="
            f"{data.attrs['free_surface']}; give one with zero_pressure, Eq. (23)"
        )
    return float(data["added_mass"].sel(mode_i="heave", mode_j="heave"))


class Roots(NamedTuple):
    """Roots of Eq. (27) at the run's current [m]; NaN where there is none."""

    stable: float
    unstable: float


def load_roots(case: TransientCase) -> Roots:
    """Roots of (27), from the input file where it holds this current."""
    if case.inputs.equilibria is not None:
        data = _input(case.inputs.equilibria, EQUILIBRIA, case, ("hull", "channel", "water"))
        here = data["case_speed"].values == case.current
        if here.any():
            return Roots(*(float(data[f"case_{name}"][here][0]) for name in Roots._fields))
    model = OneDimensionalModel(case.hull, case.channel, case.water)
    found = model.roots(case.current)
    return Roots(float(found.stable), float(found.unstable))


def _input(name: str, kind: Kind, case: TransientCase, parts: tuple[str, ...]) -> xr.Dataset:
    """Dataset of an earlier task, refused where it was made for another geometry."""
    data = records.read(Path(name), kind)
    made = records.config_of(data)
    for part in parts:
        if made[part] != records.plain(getattr(case, part)):
            raise InputError(
                f"inputs.{kind.name}={name}: made for another {part}; make it again for this one"
            )
    return data
