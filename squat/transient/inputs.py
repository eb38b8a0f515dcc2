"""What a run starts from, of earlier tasks or made anew: flow solver, added mass, roots."""

from pathlib import Path
from typing import NamedTuple

import numpy as np

from squat import records
from squat.errors import InputError
from squat.fluid.accuracy import accurate
from squat.fluid.potential import PotentialFluid
from squat.fluid.ship import LOADING, about_another_point, about_gravity
from squat.mesh import MODES, Mesh, Submesh, submesh
from squat.mesh.generate import generate
from squat.mesh.needles import told
from squat.mesh.ugrid import from_dataset
from squat.quantities import Vector
from squat.records.added_mass_kinds import ADDED_MASS
from squat.records.mesh_kinds import MESH
from squat.records.reduced_kinds import REDUCED
from squat.records.stability_kinds import EQUILIBRIA
from squat.reduced.fluid import ReducedFluid
from squat.reduced.greedy import reduce
from squat.reduced.record import Loaded, load, on_patch
from squat.stability.equilibria import OneDimensionalModel
from squat.transient.case import TransientCase

Water = PotentialFluid | ReducedFluid
"""Flow solvers with pressure and field."""


def load_fluid(case: TransientCase) -> Water:
    """The flow solver: on the whole mesh, or a reduced one where `case.model` says so."""
    if case.model != "reduced":
        mesh = about_gravity(load_mesh(case), case.hull)
        return PotentialFluid(mesh, case.water, case.free_surface, case.current)
    return load_reduced(case).fluid(case.water, case.current)


def load_reduced(case: TransientCase) -> Loaded:
    """The reduced model of the input file, or a new one; the whole mesh where snapshots need it."""
    if case.inputs.reduced is not None:
        same = ("hull", "channel", "water", "mesh", "free_surface")
        records.read_input(case.inputs.reduced, REDUCED, case, same, ignoring=LOADING)
        loaded = load(Path(case.inputs.reduced), fields=case.snapshots > 0)
        _check_motion(case, loaded.mesh.submesh)
        return loaded
    mesh = about_gravity(load_mesh(case), case.hull)
    made = reduce(mesh, case.water.density, case.free_surface, case.reduced)
    return Loaded(made.model, mesh, made.basis) if case.snapshots else on_patch(made, mesh)


def _check_motion(case: TransientCase, submesh: Submesh) -> None:
    turns = submesh.motion.center - np.array([0.0, case.channel.depth])
    apart = np.abs(turns - case.hull.center_of_gravity).max()
    if submesh.modes != case.modes or ("pitch" in case.modes and apart > 0):
        raise InputError(
            f"inputs.reduced={case.inputs.reduced}: moves in {', '.join(submesh.modes)} about "
            f"{turns.tolist()}; leave it out, or give modes and hull.gravity_center that agree"
        )


def load_mesh(case: TransientCase) -> Mesh:
    """The mesh of the input file, or a new one."""
    if case.inputs.mesh is None:
        return told(generate(submesh(case.hull, case.channel, case.modes), case.mesh))
    data = records.read_input(
        case.inputs.mesh, MESH, case, ("hull", "channel", "mesh"), ignoring=LOADING
    )
    return from_dataset(data, case.modes)


def load_added_mass(case: TransientCase) -> Vector:
    """Added-mass matrix (n, n) of Eq. (23) at q = 0, about the centre of gravity, extrapolated."""
    if case.inputs.added_mass is None:
        value, _ = accurate(case.hull, case.channel, case.accuracy, "zero_pressure")
        matrix = case.water.density * value
    else:
        data = records.read_input(
            case.inputs.added_mass, ADDED_MASS, case, ("hull", "channel", "water"), ignoring=LOADING
        )
        if data.attrs["free_surface"] != "zero_pressure":
            raise InputError(
                f"inputs.added_mass={case.inputs.added_mass}: computed with free_surface="
                f"{data.attrs['free_surface']}; give one with zero_pressure, Eq. (23)"
            )
        matrix = data["added_mass"].sel(mode_i=list(MODES), mode_j=list(MODES)).values
    shift = case.hull.center_of_gravity - case.hull.outline.center
    places = [MODES.index(mode) for mode in case.modes]
    return about_another_point(matrix, shift)[np.ix_(places, places)]


class Roots(NamedTuple):
    """Roots of Eq. (27) at the run's current [m]; NaN where there is none."""

    stable: float
    unstable: float


def load_roots(case: TransientCase) -> Roots:
    """Roots of (27), from the input file where it holds this current."""
    if case.inputs.equilibria is not None:
        data = records.read_input(
            case.inputs.equilibria, EQUILIBRIA, case, ("hull", "channel", "water"), ignoring=LOADING
        )
        here = data["case_speed"].values == case.current
        if here.any():
            return Roots(*(float(data[f"case_{name}"][here][0]) for name in Roots._fields))
    model = OneDimensionalModel(case.hull, case.channel, case.water)
    found = model.roots(case.current)
    return Roots(float(found.stable), float(found.unstable))
