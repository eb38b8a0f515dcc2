"""What bow and stern of a box add to uniform flow under it: exact, by conformal mapping.

Water of depth H flows under a vertical wall into a slit of height h, without leaving the corner.
With W = (U h/pi) ln t the map of the upper half plane onto it is

    dz/dt = (H/pi) (1 + t)^(1/2) / (t (t + b)^(1/2)),   b = (H/h)^2,

the slit at t = 0, the corner at t = -1, the water line at t = -b and the open channel at infinity:
u^2 = U^2 (b - s)/(b |1 - s|) at t = -s, on the keel (s < 1) and on the wall (1 < s < b). A long
box has one such end at the bow and one at the stern, which feel each other only by terms of the
order of exp(-2 pi L/h).
"""

from dataclasses import dataclass

import numpy as np
from scipy.integrate import quad


@dataclass(frozen=True)
class BoxEnd:
    """One end of a box in uniform flow, U the speed far in the slit.

    Parameters
    ----------
    gap
        h [m].
    depth
        H of the open water at this end [m].
    """

    gap: float
    depth: float

    @property
    def length(self) -> float:
        """Excess e [m]: the keel's suction is that of a keel longer by e.

        int (u^2/U^2 - 1) dx = (2 H/pi) (1 - h^2/H^2) artanh(h/H); 2 h/pi in a very narrow slit.
        """
        h, H = self.gap, self.depth
        return float(2 * H / np.pi * (1 - (h / H) ** 2) * np.arctanh(h / H))

    @property
    def keel_moment(self) -> float:
        """int (u^2/U^2 - 1) x dx over the keel [m2], x from the corner."""
        H, b = self.depth, self._ratio
        scale = 2 * H / np.pi

        def integrand(y: float) -> float:  # s = 1 - y^2
            root = np.sqrt(b - 1 + y * y)
            inward = np.arctanh(np.sqrt(b) * y / root) / np.sqrt(b)
            x = scale * (inward - np.arcsinh(y / np.sqrt(b - 1)))
            return float(x * scale * (1 - 1 / b) / root)

        return float(quad(integrand, 0.0, 1.0)[0])

    def wall_moment(self, height: float) -> float:
        """int u^2/U^2 (z - z_c) dz over the wall [m2], z_c `height` [m] above its foot."""
        H, b = self.depth, self._ratio

        def integrand(angle: float) -> float:  # s = 1 + (b - 1) sin^2
            s = 1 + (b - 1) * np.sin(angle) ** 2
            turned = np.arctan2(np.sqrt(b) * np.sin(angle), np.cos(angle)) / np.sqrt(b)
            z = 2 * H / np.pi * (angle - turned)
            return float((z - height) * 2 * H / np.pi * (1 - 1 / b) * np.cos(angle) ** 2 / s)

        return float(quad(integrand, 0.0, np.pi / 2)[0])

    @property
    def _ratio(self) -> float:
        return (self.depth / self.gap) ** 2
