"""Certified bounds of the reduced energies and slopes, from residuals alone.

With R_i the residual of flow i, e_i = K^-1 R_i its error, and |.| the dual norm of X,

    energies   |E_ij| <= rho |R_i| |R_j| / alpha,                       E_ij = rho R_i^T K^-1 R_j
    slopes     |dE_ij/dq_k| <= rho (|R_i,k| |R_j| + |R_j,k| |R_i| + gamma_k |R_i| |R_j|) / alpha

E is the error of the energies exactly (Galerkin orthogonality), so its derivative is the error of
the slopes. alpha and gamma_k come from the zones' metrics (`ReducedModel.metric_range`).
"""

from typing import NamedTuple

import numpy as np

from squat.fluid.model import Coefficients, Slopes
from squat.quantities import Vector
from squat.reduced.model import ReducedModel, parts


class Bounds(NamedTuple):
    """Bounds of |full - reduced| at one position, round-off floor included.

    coefficients, slopes
        For each entry.
    fields
        Of |phi_i - phi_i,N| over |phi_i,N| in the energy norm, shape (flows,).
    """

    coefficients: Coefficients
    slopes: Slopes
    fields: Vector


def bounds(model: ReducedModel, position: Vector) -> Bounds:
    """Certified bounds at `position`; raises PositionError out of the box."""
    errors, rates = residuals(model, position)
    alpha, gamma = model.metric_range(position)
    product = np.outer(errors, errors)
    mixed = rates[:, None, :] * errors[None, :, None]
    mixed = mixed + mixed.swapaxes(0, 1) + gamma * product[..., None]
    norms = np.sqrt(np.diag(model.energies(position)) / model.density)
    rounded = norms * np.sqrt(model.floor.at(model.box.clearance(position)))
    floor = np.outer(rounded, rounded)
    energies = product / alpha + floor
    slopes = mixed / alpha + gamma * floor[..., None]
    coupled = model.density * model.coupled
    return Bounds(
        parts(coupled * energies, Coefficients),
        parts(coupled[..., None] * slopes, Slopes),
        errors / np.sqrt(alpha) / norms,
    )


def residuals(model: ReducedModel, position: Vector) -> tuple[Vector, Vector]:
    """Dual norms of R_i (flows,) and of R_i,k (flows, modes)."""
    at, found = model.solve(position)
    affine_rates = model.rates(position)
    flows = 1 + len(affine_rates)
    errors, rates = np.zeros(flows), np.zeros((flows, len(affine_rates)))
    for system, u in zip(model.systems, found, strict=True):
        errors[system.flows] = system.residual_norms(at, u)
        for k, rate in enumerate(affine_rates):
            du = system.sensitivity(at, rate, u)
            rates[system.flows, k] = system.residual_rate_norms(at, rate, u, du)
    return errors, rates
