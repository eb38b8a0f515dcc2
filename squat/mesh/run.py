"""From a case to the mesh dataset."""

import xarray as xr

from squat.mesh.case import MeshCase
from squat.mesh.generate import generate
from squat.mesh.limits import PositionError
from squat.mesh.mesh import Mesh
from squat.mesh.needles import told
from squat.mesh.submesh import submesh
from squat.mesh.ugrid import to_dataset


def make(case: MeshCase, modes: tuple[str, ...] = ("surge", "heave", "pitch")) -> Mesh:
    """Mesh of a case; raises InputError where the geometry is impossible."""
    return generate(submesh(case.hull, case.channel, modes), case.mesh)


def run(case: MeshCase) -> xr.Dataset:
    """Dataset of kind `mesh`, with a warning where triangles are needles.

    Raises
    ------
    InputError
        Where the shown position is inadmissible.
    """
    coarse = submesh(case.hull, case.channel)
    q = case.position.over(coarse.limits.clearance, case.hull.outline.length)
    try:
        coarse.check(q)
    except PositionError as error:
        raise error.of("position.") from error
    mesh = told(generate(coarse, case.mesh))
    return to_dataset(mesh, q)
