"""The water's force from its kinetic energy: slopes without sensitivity solves, and Lagrange.

With K(q) phi_j = r_j(q) and phi_0 of unit current (docs/theory/energy.md), K_k = dK/dq_k and
r_j,k = dr_j/dq_k,

    da/dq_k    = -rho phi_0^T K_k phi_0
    db_j/dq_k  =  rho (r_j,k - K_k phi_j)^T phi_0
    dc_ij/dq_k =  rho (r_i,k^T phi_j + r_j,k^T phi_i - phi_i^T K_k phi_j)

because the potentials minimise the energies that a, b, c are made of.
"""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from scipy import sparse

from squat.dynamics.lagrangian import inertial_force
from squat.fluid.model import Coefficients, Slopes
from squat.quantities import Vector


class UnitFlows(NamedTuple):
    """Flows of unit speed past the hull at one position.

    position (n,), theta (terms,) of K, loads r_j (n, nodes), phi_0 of unit current (nodes,) and
    phi_j of unit velocities (n, nodes).
    """

    position: Vector
    theta: Vector
    loads: Vector
    current: Vector
    unit: Vector

    def coefficients(self, density: float, inflow: Vector, *, crossed: bool) -> Coefficients:
        """Coefficients a, b, c from r_0 = `inflow` (nodes,); b = 0 unless `crossed`."""
        c = density * self.loads @ self.unit.T
        b = density * self.loads @ self.current if crossed else np.zeros(len(self.loads))
        return Coefficients(density * float(inflow @ self.current), b, (c + c.T) / 2)

    def slopes(
        self,
        density: float,
        stiffness: Sequence[sparse.csc_array],
        loads: Vector,
        *,
        crossed: bool,
    ) -> Slopes:
        """Slopes of a, b, c from K_k (modes) and r_j,k (modes j, modes k, nodes)."""
        phi0, phi = self.current, self.unit
        n = len(phi)
        a, b, c = np.zeros(n), np.zeros((n, n)), np.zeros((n, n, n))
        for k, K in enumerate(stiffness):
            bent = phi @ K
            a[k] = -density * float(phi0 @ (K @ phi0))
            half = loads[:, k] @ phi.T
            c[:, :, k] = density * (half + half.T - bent @ phi.T)
            if crossed:
                b[:, k] = density * (loads[:, k] - bent) @ phi0
        return Slopes(a, b, c)


def gyroscopic(slopes: Slopes, current: float) -> Vector:
    """Gam_ij = V (db_j/dq_i - db_i/dq_j), shape (n, n): antisymmetric, does no work."""
    return current * (slopes.b.T - slopes.b)


def dynamic_force(
    coefficients: Coefficients,
    slopes: Slopes,
    current: float,
    velocity: Vector,
    acceleration: Vector,
    current_rate: float = 0.0,
) -> Vector:
    """Generalised force of the water's motion on the ship, shape (n,) [N/m].

    V^2 a'/2 + Gam q' - b dV/dt - c q'' - (dc_ij/dq_k - dc_jk/dq_i/2) q_j' q_k'; the pressure of
    the water at rest and of the stream's head, -d(U_h + U_B)/dq, comes on top.

    Parameters
    ----------
    current, current_rate
        V [m/s] and dV/dt [m/s2].
    velocity, acceleration
        q' and q'', shape (n,).
    """
    steady = current**2 / 2 * slopes.a + gyroscopic(slopes, current) @ velocity
    inertia = coefficients.b * current_rate + coefficients.c @ acceleration
    return np.asarray(steady - inertia + inertial_force(slopes.c, velocity))
