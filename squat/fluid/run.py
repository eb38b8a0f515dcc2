"""Added mass of one hull, from the case to its dataset."""

from typing import Annotated

import numpy as np
import xarray as xr
from pydantic import Field
from pydantic.dataclasses import dataclass

from squat.channel import AnyHull, Channel
from squat.fluid.accuracy import Accuracy, accurate
from squat.fluid.added_mass import AddedMass, FreeSurface
from squat.fluid.hull_modes import HullMode, bending
from squat.mesh import MeshSize, submesh
from squat.mesh.generate import generate
from squat.mesh.needles import told
from squat.quantities import STRICT
from squat.records import build
from squat.records.added_mass_kinds import ADDED_MASS, entry_units, pressure_units
from squat.water import Water


@dataclass(frozen=True, kw_only=True, config=STRICT)
class AddedMassCase:
    """A hull in a channel whose added mass is wanted (section 3.2).

    Parameters
    ----------
    mesh
        Mesh of the raw values and of the pressure fields.
    accuracy
        Meshes of the extrapolated values.
    free_surface
        `zero_pressure`, Eq. (23), or `rigid_lid`, Eq. (19).
    bending_modes
        Number of free-free girder modes beside surge, heave and pitch.
    """

    hull: AnyHull
    channel: Channel
    water: Water
    mesh: MeshSize
    accuracy: Accuracy
    free_surface: FreeSurface
    bending_modes: Annotated[int, Field(strict=True, ge=0, le=20)]

    @property
    def girder(self) -> list[HullMode]:
        """The hull's bending modes, along its water line."""
        ends = self.hull.outline.vertices[[0, -1], 0]
        length = float(ends[1] - ends[0])
        return [bending(n + 1, float(ends[0]), length) for n in range(self.bending_modes)]

    @property
    def mass(self) -> float:
        """Ship mass per unit width [kg/m]: the displaced water's."""
        return self.water.density * self.hull.outline.area


def run(case: AddedMassCase) -> xr.Dataset:
    """Dataset of kind `added_mass`."""
    rho = case.water.density
    mesh = told(generate(submesh(case.hull, case.channel), case.mesh))
    raw = AddedMass(mesh, case.free_surface, case.girder)
    value, error = accurate(case.hull, case.channel, case.accuracy, case.free_surface, case.girder)
    heave = raw.names.index("heave")
    circle = np.pi * (case.hull.outline.length / 2) ** 2
    data = {
        "mode_i": raw.names,
        "mode_j": raw.names,
        "mode": raw.names,
        "entry_units": entry_units(raw.names),
        "pressure_units": pressure_units(raw.names),
        "added_mass": rho * value,
        "added_mass_error": rho * error,
        "added_mass_mesh": rho * raw.matrix,
        "added_mass_mesh_error": rho * (np.abs(value - raw.matrix) + error),
        "inertia_coefficient": value[heave, heave] / circle,
        "inertia_coefficient_error": error[heave, heave] / circle,
        "inertia_coefficient_mesh": raw.matrix[heave, heave] / circle,
        "ship_mass": case.mass,
        "mass_ratio": rho * value[heave, heave] / case.mass,
        "mass_ratio_error": rho * error[heave, heave] / case.mass,
        "pressure": rho * raw.nodal_potentials(),
        "node_x": mesh.points[:, 0],
        "node_z": mesh.points[:, 1],
        "face_node": mesh.triangles,
    }
    how = {"free_surface": case.free_surface, "residual": raw.solution.residual}
    return build(ADDED_MASS, data, how)
