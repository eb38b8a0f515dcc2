"""What a run needs before it starts: mesh, added mass, loop."""

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import NamedTuple

import numpy as np
import xarray as xr

from squat import records
from squat.coupling import PREDICTORS, Coupling, Scheme, corrected, standard
from squat.dynamics import INTEGRATORS, Motion, RigidBody
from squat.errors import InputError
from squat.fluid.accuracy import accurate
from squat.fluid.model import forget
from squat.fluid.potential import PotentialFluid
from squat.fluid.rates import RATES
from squat.mesh import Mesh, submesh
from squat.mesh.generate import generate
from squat.mesh.ugrid import from_dataset
from squat.quantities import Vector
from squat.records.kinds import ADDED_MASS, EQUILIBRIA, MESH
from squat.records.schema import Kind
from squat.stability.equilibria import OneDimensionalModel
from squat.transient.case import TransientCase
from squat.transient.problem import ShipProblem

MODES = ("heave",)


@dataclass(frozen=True)
class Parts:
    """The pieces of one run; `added_mass` is m_add [kg/m] of (23) at w = 0."""

    problem: ShipProblem
    fluid: PotentialFluid
    coupling: Coupling
    added_mass: float
    omega: float
    dt: float

    def forget(self) -> None:
        """Let the flow solvers answer as new ones would."""
        forget(self.problem.fluid)
        forget(self.fluid)


def prepare(case: TransientCase) -> Parts:
    """Mesh, added mass and loop of `case`, from its input files where given."""
    mass = case.mass
    body = RigidBody(MODES, mass, 0.0, case.water.gravity)
    fluid = PotentialFluid(load_mesh(case), case.water, case.free_surface, case.current)
    problem = ShipProblem(body, fluid, RATES[case.coupling.potential_rate])
    added = load_added_mass(case)
    omega = case.omega(added)
    return Parts(
        problem, fluid, _coupling(case, body, fluid, added), added, omega, case.time.step(omega)
    )


def _coupling(
    case: TransientCase, body: RigidBody, fluid: PotentialFluid, added_mass: float
) -> Coupling:
    choice = case.coupling
    return Coupling(
        _scheme(case, body.matrix, fluid, added_mass),
        INTEGRATORS[choice.integrator],
        choice.accelerator,
        PREDICTORS[choice.predictor],
        choice.criterion,
    )


def _scheme(
    case: TransientCase, mass: Vector, fluid: PotentialFluid, added_mass: float
) -> Callable[[Motion], Scheme]:
    """The structure solve that follows a motion, see `CouplingChoice.scheme`."""
    if case.coupling.scheme == "consistent":
        beta = case.coupling.beta
        return lambda motion: corrected(mass, beta * fluid.coefficients(motion.position).c)
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
