"""Positions that the hull cannot take, each refused by name."""

import re
from dataclasses import dataclass

import numpy as np

from squat.errors import InputError
from squat.quantities import Vector

PITCH = np.deg2rad(15.0)
"""Largest pitch [rad] either way."""
CLEARANCE = 0.02
"""Least clearance over that at rest."""
WALL = 0.1
"""Least depth of the foot of a wall over its depth at rest."""
SURGE = 0.5
"""Largest surge over the distance to the part of the mesh that stands still."""


_PART = re.compile(r"\b(?=(?:surge|heave|pitch)=)")
"""Where in a message a part of the position begins."""


class PositionError(InputError):
    """The hull cannot take this position."""

    def of(self, keys: str) -> "PositionError":
        """The same about a position whose keys begin with `keys`, `initial_` say."""
        return type(self)(_PART.sub(keys, str(self)))


class GroundedError(PositionError):
    """The hull is closer to the bottom than 0.02 of its clearance at rest."""


class LiftedError(PositionError):
    """The hull is higher than half its draft, or its walls leave the water."""


class FoldedError(PositionError):
    """A coarse triangle would turn over: beyond what this submesh can follow."""


@dataclass(frozen=True, eq=False)
class Limits:
    """Admissible positions of one hull in one channel.

    Parameters
    ----------
    draft, wall
        T and the height of the vertical sides [m].
    level
        H [m].
    reach
        Least distance [m] between hull and the fixed part of the mesh.
    clearance
        Least height of the hull over the bottom at rest [m].
    fraction
        Least clearance over that at rest: closer, the ship counts as grounded.
    """

    draft: float
    wall: float
    level: float
    reach: float
    clearance: float
    fraction: float = CLEARANCE

    def check(self, q: Vector, hull: Vector, clearance: float) -> None:
        """Raise PositionError unless q is admissible.

        Parameters
        ----------
        q
            (surge, heave, pitch), shape (3,).
        hull
            Moved hull points (n, 2) [m].
        clearance
            Least height [m] of the moved hull over the bottom.
        """
        surge, heave, pitch = q
        if not np.all(np.isfinite(q)):
            raise PositionError(f"position={q.tolist()}: must be finite")
        if abs(surge) > SURGE * self.reach:
            raise PositionError(f"surge={surge:g}: must be within {SURGE * self.reach:g} m")
        if abs(pitch) > PITCH * (1 + 1e-12):
            raise PositionError(f"pitch={pitch:g}: must be within {PITCH:.6g} rad (15 degrees)")
        if clearance < self.fraction * self.clearance * (1 - 1e-12):
            raise GroundedError(
                f"heave={heave:g} pitch={pitch:g}: grounded, clearance {clearance:.4g} m "
                f"is less than {self.fraction:g} of {self.clearance:g} m at rest"
            )
        if heave > self.draft / 2 * (1 + 1e-12):
            raise LiftedError(f"heave={heave:g}: must be at most draft/2={self.draft / 2:g}")
        depth = self.level - hull[:, 1].max()
        if depth < WALL * self.wall * (1 - 1e-12):
            raise LiftedError(
                f"heave={heave:g} pitch={pitch:g}: lifts the hull's vertical sides "
                f"({self.wall:g} m) out; their feet must stay {WALL * self.wall:.4g} m below water"
            )
