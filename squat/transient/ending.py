"""What ends a run early: the bottom, too much trim, or a turning point."""

from dataclasses import dataclass
from typing import Literal

from squat.mesh import Submesh
from squat.mesh.limits import PITCH
from squat.quantities import Vector
from squat.transient.case import TransientCase
from squat.transient.parts import Parts

_TRIM = 0.98
"""Share of the mesh's largest pitch beyond which a run ends."""


@dataclass
class Ending:
    """Watches the accepted steps of one run.

    Parameters
    ----------
    submesh
        The hull over the bottom.
    least
        Clearance [m] below which the ship counts as grounded.
    heave
        Place of heave in q.
    resolved
        Speed [m/s] below which the sign of a velocity says nothing: it moves the ship by less in
        a step than the tolerance to which the step is solved. None: turning points are no end.
    direction
        Sign of the first resolved velocity; 0 while the ship has not moved.
    """

    submesh: Submesh
    least: float
    heave: int
    resolved: float | None
    direction: int = 0
    status: Literal["grounded", "overtrimmed", "turned"] | None = None

    @staticmethod
    def of(case: TransientCase, parts: Parts) -> "Ending":
        """What ends `case`."""
        submesh = parts.fluid.mesh.submesh
        criterion = case.coupling.criterion
        scale = 1.0 if criterion.name == "absolute" else abs(case.initial_heave)
        turns = case.time.until == "turn"
        resolved = criterion.tolerance * scale / parts.dt if turns else None
        return Ending(submesh, case.grounding * submesh.limits.clearance, case.place, resolved)

    def see(self, position: Vector, velocity: Vector) -> None:
        """Take note of one more accepted step, q and q' (n,)."""
        speed = float(velocity[self.heave])
        if self.submesh.clearance(position) < self.least:
            self.status = "grounded"
        elif abs(self.submesh.full(position)[2]) > _TRIM * PITCH:
            self.status = "overtrimmed"
        elif self.resolved is None:
            return
        elif self.direction == 0:
            self.direction = (speed > self.resolved) - (speed < -self.resolved)
        elif speed * self.direction < 0:
            self.status = "turned"
