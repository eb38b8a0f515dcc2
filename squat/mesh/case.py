"""What a mesh is made from."""

from pydantic.dataclasses import dataclass

from squat.channel import AnyHull, Channel
from squat.mesh.size import MeshSize
from squat.quantities import STRICT, Position, Real


@dataclass(frozen=True, kw_only=True, config=STRICT)
class Place:
    """A position of the hull: surge, heave [m] and pitch [rad], positive bow down."""

    surge: Position
    heave: Position
    pitch: Real


@dataclass(frozen=True, kw_only=True, config=STRICT)
class MeshCase:
    """A hull in a channel, the mesh around it, and a position to show it moved to."""

    hull: AnyHull
    channel: Channel
    mesh: MeshSize
    position: Place
