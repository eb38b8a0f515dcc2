"""Amplification factors: how fast the iteration of one time step converges, in closed form.

The derivation is in docs/theory/piston.md. Where the fluid answers with
F = -M_f q'' - C q' - K q + ..., one coupling iteration takes q^k to G q^k + ... with

    G = (M + m_add)^{-1} [m_add - M_f - (s1/s3) dt C - (dt^2/s3) K].
"""

import numpy as np
from numpy.typing import ArrayLike

from squat.dynamics import Integrator
from squat.quantities import Vector


def amplification_factor(
    mass: ArrayLike,
    fluid_mass: ArrayLike,
    stiffness: ArrayLike,
    dt: ArrayLike,
    integrator: Integrator,
    added_mass: ArrayLike = 0.0,
) -> Vector:
    """G of one degree of freedom, elementwise over arrays that broadcast; m_add = 0: standard.

    Parameters
    ----------
    mass, fluid_mass, added_mass
        m, m_f and m_add [kg].
    stiffness
        k [N/m]; 2 rho g S for the piston.
    dt
        Time step [s].

    Notes
    -----
    For the piston (k = 2 rho g S) these are Eq. (11) and its corrected form with Newmark,
    -(m_f + 2 dt^2 rho g S)/m for centred differences, and, not in the paper,
    (m_add - m_f - 2 dt^2 rho g S)/(m + m_add) for the corrected centred scheme.
    """
    m, m_f, k, h, m_add = (
        np.asarray(value, float) for value in (mass, fluid_mass, stiffness, dt, added_mass)
    )
    return np.asarray((m_add - m_f - h**2 * k / integrator.s3) / (m + m_add))


def amplification_matrix(
    mass: Vector,
    fluid_mass: Vector,
    stiffness: Vector,
    dt: float,
    integrator: Integrator,
    added_mass: Vector,
) -> Vector:
    """G of n degrees of freedom, shape (n, n); it converges when its spectral radius is < 1."""
    change = added_mass - fluid_mass - dt**2 / integrator.s3 * stiffness
    return np.asarray(np.linalg.solve(mass + added_mass, change), float)


def smallest_added_mass(
    mass: float, fluid_mass: float, stiffness: float, dt: float, integrator: Integrator
) -> float:
    """The m_add [kg] above which the iteration converges: (m_f + dt^2 k/s3 - m)/2.

    From |G| < 1; the paper takes the correction for unconditional, which it is not.
    """
    return (fluid_mass + dt**2 * stiffness / integrator.s3 - mass) / 2


def predicted_iterations(factor: ArrayLike, first_error: ArrayLike, tolerance: float) -> Vector:
    """Structure solves until |q^{k+1} - q^k| < tolerance, from the `hold` predictor.

    Parameters
    ----------
    factor
        G, broadcast against `first_error`.
    first_error
        |q^1 - q| [m], the error of the first iterate.
    tolerance
        [m].

    Returns
    -------
    Whole numbers, or infinity where the iteration does not converge. The second and later
    residuals are |G|^{k-2} |1 - G| |q^1 - q|; at least two solves are counted.
    """
    g = np.abs(np.asarray(factor, float))
    second = np.abs(1 - np.asarray(factor, float)) * np.abs(np.asarray(first_error, float))
    with np.errstate(divide="ignore", invalid="ignore"):
        more = np.log(tolerance / second) / np.log(g)
    count = np.where(second < tolerance, 2.0, 3.0 + np.floor(more))
    return np.where(g < 1, count, np.inf)


def limit_mass_ratio(steps_per_period: int, integrator: Integrator) -> float:
    """The m_f/m below which the standard scheme converges, for dt = 2 pi/(omega N).

    With omega^2 = k/(m + m_f) of Eq. (5), G = -(r + e (1 + r)) for r = m_f/m and
    e = (2 pi/N)^2/s3; |G| = 1 at r = (1 - e)/(1 + e), which tends to the paper's 1 as dt -> 0.
    """
    e = (2 * np.pi / steps_per_period) ** 2 / integrator.s3
    return float((1 - e) / (1 + e))
