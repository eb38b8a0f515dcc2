"""What ends a run early: the bottom, or a turning point."""

from dataclasses import dataclass
from typing import Literal

from squat.quantities import Vector
from squat.transient.case import TransientCase
from squat.transient.parts import Parts


@dataclass
class Ending:
    """Watches the accepted steps of one run.

    Parameters
    ----------
    lowest
        Heave [m] below which the ship counts as grounded.
    resolved
        Speed [m/s] below which the sign of a velocity says nothing: it moves the ship by less in
        a step than the tolerance to which the step is solved. None: turning points are no end.
    direction
        Sign of the first resolved velocity; 0 while the ship has not moved.
    """

    lowest: float
    resolved: float | None
    direction: int = 0
    status: Literal["grounded", "turned"] | None = None

    @staticmethod
    def of(case: TransientCase, parts: Parts) -> "Ending":
        """What ends `case`."""
        clearance = parts.fluid.mesh.submesh.limits.clearance
        criterion = case.coupling.criterion
        scale = 1.0 if criterion.name == "absolute" else abs(case.initial_heave)
        turns = case.time.until == "turn"
        resolved = criterion.tolerance * scale / parts.dt if turns else None
        return Ending((case.grounding - 1) * clearance, resolved)

    def see(self, position: Vector, velocity: Vector) -> None:
        """Take note of one more accepted step, heave first in both (n,)."""
        heave, speed = float(position[0]), float(velocity[0])
        if heave < self.lowest:
            self.status = "grounded"
        elif self.resolved is None:
            return
        elif self.direction == 0:
            self.direction = (speed > self.resolved) - (speed < -self.resolved)
        elif speed * self.direction < 0:
            self.status = "turned"
