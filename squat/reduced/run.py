"""Reduced models, from the case to the record."""

from typing import NamedTuple

import xarray as xr

from squat.fluid.ship import LOADING, about_gravity
from squat.mesh import Mesh, submesh
from squat.mesh.needles import told
from squat.mesh.ugrid import from_dataset
from squat.records import read_input
from squat.records.mesh_kinds import MESH
from squat.reduced.case import ReducedCase
from squat.reduced.greedy import Reduced, reduce
from squat.reduced.record import FIELDS, HULL, fields_record, on_patch, to_record


class Result(NamedTuple):
    """The record of a reduced model, and its groups: the basis beside the hull, and everywhere."""

    dataset: xr.Dataset
    groups: dict[str, xr.Dataset]


def run(case: ReducedCase) -> Result:
    """Dataset of kind `reduced`."""
    made, mesh = make(case)
    near = on_patch(made, mesh)
    groups = {HULL: fields_record(near.mesh, near.basis)}
    if case.fields:
        groups[FIELDS] = fields_record(mesh, made.basis)
    return Result(to_record(made, len(mesh.points)), groups)


def make(case: ReducedCase) -> tuple[Reduced, Mesh]:
    """The reduced model of a case, and the mesh that it was made on."""
    mesh = _mesh(case)
    return reduce(mesh, case.water.density, case.free_surface, case.reduced), mesh


def _mesh(case: ReducedCase) -> Mesh:
    modes = case.reduced.box.modes
    if case.inputs.mesh is not None:
        same = ("hull", "channel", "mesh")
        data = read_input(case.inputs.mesh, MESH, case, same, ignoring=LOADING)
        return about_gravity(from_dataset(data, modes), case.hull)
    # gmsh takes as long to import as all the rest, and needs graphics libraries.
    from squat.mesh.generate import generate  # noqa: PLC0415

    mesh = told(generate(submesh(case.hull, case.channel, modes), case.mesh))
    return about_gravity(mesh, case.hull)
