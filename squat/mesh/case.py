"""What a mesh is made from."""

import numpy as np
from pydantic.dataclasses import dataclass

from squat.channel import AnyHull, Channel
from squat.mesh.size import MeshSize
from squat.quantities import STRICT, Position, Real, Vector


@dataclass(frozen=True, kw_only=True, config=STRICT)
class Place:
    """A position of the hull: surge, heave [m] and pitch [rad], positive bow down.

    None: heave down by half the clearance; pitch that lowers the bow by a tenth of it where heave
    is None too, else 0.
    """

    surge: Position
    heave: Position | None
    pitch: Real | None

    def over(self, clearance: float, length: float) -> Vector:
        """q (3,) of a hull of that `length` [m] with that `clearance` at rest [m]."""
        heave = -clearance / 2 if self.heave is None else self.heave
        tenth = 0.2 * clearance / length if self.heave is None else 0.0
        pitch = tenth if self.pitch is None else self.pitch
        return np.array([self.surge, heave, pitch])


@dataclass(frozen=True, kw_only=True, config=STRICT)
class MeshCase:
    """A hull in a channel, the mesh around it, and a position to show it moved to."""

    hull: AnyHull
    channel: Channel
    mesh: MeshSize
    position: Place
