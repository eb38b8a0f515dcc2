"""Reduced models, from the case to the record."""

from pathlib import Path
from typing import NamedTuple

import xarray as xr

from squat import records
from squat.errors import InputError
from squat.fluid.ship import about_gravity
from squat.mesh import Mesh
from squat.mesh.ugrid import from_dataset
from squat.records.kinds import MESH
from squat.reduced.case import ReducedCase
from squat.reduced.greedy import reduce
from squat.reduced.record import FIELDS, HULL, fields_record, on_patch, to_record


class Result(NamedTuple):
    """The record of a reduced model, and its groups: the basis beside the hull, and everywhere."""

    dataset: xr.Dataset
    groups: dict[str, xr.Dataset]


def run(case: ReducedCase) -> Result:
    """Dataset of kind `reduced`."""
    mesh = about_gravity(_mesh(case), case.hull)
    made = reduce(mesh, case.water.density, case.free_surface, case.reduced)
    near = on_patch(made, mesh)
    groups = {HULL: fields_record(near.mesh, near.basis)}
    if case.fields:
        groups[FIELDS] = fields_record(mesh, made.basis)
    return Result(to_record(made, len(mesh.points)), groups)


def _mesh(case: ReducedCase) -> Mesh:
    modes = case.reduced.box.modes
    if case.inputs.mesh is None:
        # gmsh takes as long to import as all the rest, and needs graphics libraries.
        from squat.mesh import submesh  # noqa: PLC0415
        from squat.mesh.generate import generate  # noqa: PLC0415

        return generate(submesh(case.hull, case.channel, modes), case.mesh)
    data = records.read(Path(case.inputs.mesh), MESH)
    made = records.config_of(data)
    for part in ("hull", "channel", "mesh"):
        if made[part] != records.plain(getattr(case, part)):
            raise InputError(
                f"inputs.mesh={case.inputs.mesh}: made for another {part}; make it again"
            )
    return from_dataset(data, modes)
