"""Position, velocity and acceleration of n degrees of freedom at one instant."""

from typing import NamedTuple

from squat.quantities import Vector


class Motion(NamedTuple):
    """State of n degrees of freedom: q, q', q'', each of shape (n,).

    For heave and for the piston n = 1 and q is w [m], positive up.
    """

    position: Vector
    velocity: Vector
    acceleration: Vector
