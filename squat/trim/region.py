"""Heaves and trims that a ship can take between ground and water line."""

from typing import NamedTuple

import numpy as np
from scipy.optimize import brentq

from squat.mesh import Submesh
from squat.mesh.limits import WALL
from squat.quantities import Vector

_WALL = 1.01 * WALL
_ROOM = 0.1
"""Least room for heave at the greatest trim over that at rest."""
HEAVES = 33
"""Points over heave, dense near the ground."""


class Region(NamedTuple):
    """Where the ship may be.

    Parameters
    ----------
    submesh
        The hull over the bottom.
    pitch
        Greatest trim either way [rad].
    least
        Clearance [m] at which the ship counts as grounded.
    """

    submesh: Submesh
    pitch: float
    least: float

    def low(self, pitch: float) -> float:
        """Heave [m] at which the ship grounds at `pitch`."""
        return self.least - self.submesh.clearance(np.array([0.0, pitch]))

    def high(self, pitch: float) -> float:
        """Heave [m] up to which its vertical sides stay in the water at `pitch`."""
        limits = self.submesh.limits
        full = np.array([0.0, 0.0, pitch])
        top = self.submesh.motion.positions(full)[self.submesh.hull, 1].max()
        return float(min(limits.draft / 2, limits.level - top - _WALL * limits.wall))

    def greatest_pitch(self) -> float:
        """Trim [rad] up to `pitch` at which, either way, a tenth of the heaves at rest is left.

        A long hull over a small gap touches the ground at one end while the other leaves the water.
        """
        room = self.high(0.0) - self.low(0.0)

        def left(pitch: float) -> float:
            rooms = (self.high(p) - self.low(p) for p in (pitch, -pitch))
            return min(rooms) - _ROOM * room

        return float(brentq(left, 0.0, self.pitch)) if left(self.pitch) < 0 else self.pitch

    def heaves(self, pitch: float) -> Vector:
        """Heaves [m] from the ground up at `pitch`, in proportion to the clearance."""
        low, high = self.low(pitch), self.high(pitch)
        return low - self.least + np.geomspace(self.least, high - low + self.least, HEAVES)
