"""Meshes of the water around a hull, and their motion with it.

gmsh is imported by `squat.mesh.generate` alone: reading, moving and solving do without it.
"""

from squat.mesh.limits import FoldedError, GroundedError, LiftedError, PositionError
from squat.mesh.mesh import Mesh, subdivided
from squat.mesh.motion import MODES
from squat.mesh.quality import quality, smallest_angle
from squat.mesh.size import MeshSize
from squat.mesh.submesh import BOUNDARIES, Submesh, submesh

__all__ = [
    "BOUNDARIES",
    "MODES",
    "FoldedError",
    "GroundedError",
    "LiftedError",
    "Mesh",
    "MeshSize",
    "PositionError",
    "Submesh",
    "quality",
    "smallest_angle",
    "subdivided",
    "submesh",
]
