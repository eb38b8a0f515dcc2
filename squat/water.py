"""The water that everything else moves in."""

from pydantic.dataclasses import dataclass

from squat.quantities import STRICT, Acceleration, Density


@dataclass(frozen=True, kw_only=True, config=STRICT)
class Water:
    """Incompressible water under gravity (sections 2.4 and 3.1 of the paper).

    Parameters
    ----------
    density
        rho [kg/m3].
    gravity
        g [m/s2].
    """

    density: Density
    gravity: Acceleration
