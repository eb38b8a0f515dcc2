"""M(w) and U(w) of a ship in heave on curves, in plain floats: a `dynamics.OneMode`."""

import math

import numpy as np

from squat.dynamics.hydrostatics import heave_stiffness
from squat.errors import InputError
from squat.fluid.curves import SLACK, Curves
from squat.fluid.energy import ShipEnergy


class HeaveEnergy:
    """M = m + c and U of `ship`, whose model must be `Curves`, with their slopes.

    The sides at the water line are vertical: U_h + m g w + U_B = rho g L w^2/2 + tilt w.
    """

    def __init__(self, ship: ShipEnergy) -> None:
        curves, still, body = ship.model, ship.hydrostatics, ship.body
        if not isinstance(curves, Curves) or body.modes != ("heave",):
            raise InputError("model: plain floats need model=curves and heave alone")
        self._beyond = curves.beyond
        self._clearance = curves.clearance
        low, high = curves.logarithms
        self._middle, self._half = (low + high) / 2, (high - low) / 2
        self._orders = np.arange(len(curves.series[0]), dtype=float)
        (a, _, c), (da, _, dc) = curves.tables[:2]
        stream = ship.current**2 / 2
        self._rows = np.array([c, -stream * a, dc, -stream * da])
        self._mass = body.mass
        self._spring = heave_stiffness(still.water, still.length)
        weight = body.gravity * (body.mass - still.water.density * still.rest[1])
        self._tilt = weight - stream * still.water.density * still.length

    def __call__(self, w: float) -> tuple[float, float, float, float]:
        """M [kg/m], U [J/m], dM/dw, dU/dw; raises PositionError beyond the curves."""
        gap = self._clearance + w
        x = (math.log(gap) - self._middle) / self._half if gap > 0 else -math.inf
        if not -1 <= x <= 1:
            if not abs(x) <= 1 + SLACK:
                raise self._beyond(w)
            x = math.copysign(1.0, x)
        basis = np.cos(self._orders * math.acos(x))
        c, suction, dc, pull = (self._rows @ basis).tolist()
        line = self._spring * w
        return (
            self._mass + c,
            suction + w * (line / 2 + self._tilt),
            dc / gap,
            pull / gap + line + self._tilt,
        )
