"""Ships as systems of one mode: on a given mesh, and on three meshes for an error."""

from dataclasses import dataclass
from typing import Literal

import numpy as np

from squat.channel import AnyHull, Channel, check_afloat
from squat.fluid.accuracy import LEVELS, Accuracy, Estimate, extrapolate
from squat.fluid.curves import Curves
from squat.fluid.direct import DirectEnergies
from squat.mesh import Mesh, MeshSize, submesh
from squat.mesh.generate import generate
from squat.mesh.needles import told
from squat.quantities import Vector
from squat.stability.heave import HeaveSystem
from squat.water import Water

Surface = Literal["rigid_lid", "blend"]
MODES = ("heave",)
_WALL = 0.9
"""Share of the hull's vertical sides that may leave the water."""


@dataclass(frozen=True)
class Ship:
    """What floats where: all that the energies depend on, but for the mesh.

    Parameters
    ----------
    free_surface
        `rigid_lid`, Eq. (19), or `blend`: the hull's motion with zero pressure, Eq. (23).
    grounding
        Clearance over that at rest, below which the ship counts as grounded.
    name
        Key of the hull where there are several; for messages.
    """

    hull: AnyHull
    channel: Channel
    water: Water
    free_surface: Surface
    grounding: float
    name: str = ""

    def on(self, size: MeshSize) -> HeaveSystem:
        """The ship on a mesh of that size, in still water."""
        return self._system(told(self._mesh(size), whose=self.name))

    def levels(self, accuracy: Accuracy) -> list[HeaveSystem]:
        """The ship on three graded P2 meshes, the coarsest first."""
        check_afloat(self.hull, self.channel)
        sizes = (accuracy.size(self.hull, self.channel, level) for level in range(LEVELS))
        meshes = [self._mesh(size) for size in sizes]
        told(*meshes, whose=self.name)
        return [self._system(mesh) for mesh in meshes]

    def _mesh(self, size: MeshSize) -> Mesh:
        return generate(submesh(self.hull, self.channel, MODES), size)

    def _system(self, mesh: Mesh) -> HeaveSystem:
        limits = mesh.submesh.limits
        low, high = (
            (self.grounding - 1) * limits.clearance,
            min(limits.draft / 2, _WALL * limits.wall),
        )
        curves = Curves.of(DirectEnergies(mesh, self.water, self.free_surface), low, high)
        return HeaveSystem.of(self.hull, self.water, curves)


def estimate(values: list[float], accuracy: Accuracy) -> Estimate:
    """One number from its values on the three meshes of `Ship.levels`; NaN where one is NaN."""
    levels: list[Vector] = [np.array(value) for value in values]
    return extrapolate(levels, float(accuracy.refinement), accuracy.safety)
