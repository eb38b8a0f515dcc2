"""Heave added mass of rectangles in deep water, by conformal mapping.

With zero pressure on the free surface the potential is odd about it, so the heaving hull is the
lower half of a rectangle 2a x 2T that moves vertically in unbounded water. Schwarz and Christoffel
map the outside of the unit circle onto the outside of that rectangle:

    dz/dzeta = R (1 - 2 cos(2 alpha)/zeta^2 + 1/zeta^4)^{1/2}
    z = R zeta + R cos(2 alpha)/zeta + ...

and the added mass of vertical translation is rho [2 pi R^2 (1 + cos 2 alpha) - 4 a T], by the
residue of z(zeta); the hull has half of it. For an ellipse the same formula gives rho pi a^2.
"""

import math

import numpy as np
from scipy.integrate import quad
from scipy.optimize import brentq


def _half_side(alpha: float) -> float:
    """Half the side facing x, over R: integral of |dz/dtheta| from 0 to alpha."""
    # theta = arcsin(sin(alpha) sin(t)) removes the square root's end at alpha.
    s = math.sin(alpha)
    value, _ = quad(
        lambda t: 2 * s**2 * np.cos(t) ** 2 / np.sqrt(1 - (s * np.sin(t)) ** 2),
        0,
        math.pi / 2,
        epsabs=0,
        epsrel=1e-13,
    )
    return float(value)


def heave_inertia_coefficient(a_over_T: float) -> float:
    """i = m_22/(rho pi a^2), Eq. (28), in infinitely deep water; to about 12 digits."""

    def mismatch(alpha: float) -> float:
        return _half_side(math.pi / 2 - alpha) - a_over_T * _half_side(alpha)

    alpha = float(brentq(mismatch, 1e-9, math.pi / 2 - 1e-9, xtol=1e-15))
    radius = a_over_T / _half_side(math.pi / 2 - alpha)  # for T = 1
    full = 2 * math.pi * radius**2 * (1 + math.cos(2 * alpha)) - 4 * a_over_T
    return full / 2 / (math.pi * a_over_T**2)
