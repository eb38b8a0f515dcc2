"""What a coupled problem must offer to be solved by the loop."""

from typing import Any, NamedTuple, Protocol

from squat.dynamics import Motion
from squat.quantities import Vector


class Load(NamedTuple):
    """The fluid's answer to a trial motion: force of shape (n,), and its memory of the step.

    The memory (the ship's potential at earlier levels, say) is opaque to the loop: it is handed
    back unchanged at the next step if this answer is the one accepted.
    """

    force: Vector
    memory: Any = None


class Problem(Protocol):
    """A structure of n degrees of freedom, M q'' = F(q, q', q''), with F from a fluid.

    `mass` is M, of shape (n, n) [kg or kg/m, moments in kg m]; F includes weight and springs.
    """

    @property
    def mass(self) -> Vector:
        """Structural mass matrix, shape (n, n)."""
        ...

    def load(self, trial: Motion, memory: Any, dt: float) -> Load:
        """Force for `trial`, given what the last accepted step remembered."""
        ...
