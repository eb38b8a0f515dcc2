"""The variational force: derivatives, reciprocity, exact values, what pressure must agree with."""

from functools import cache

import numpy as np
import pytest

from squat.dynamics import RigidBody
from squat.fluid.energy import ShipEnergy, still_water
from squat.fluid.potential import PotentialFluid
from squat.mesh import subdivided
from squat.water import Water
from tests.hulls import NAMES, hull, zones

WATER = Water(density=1000.0, gravity=9.81)
Q = np.array([0.7, -2.0, 0.03])
HULLS = pytest.mark.parametrize("name", NAMES)
SURFACES = pytest.mark.parametrize("surface", ["rigid_lid", "zero_pressure", "blend"])


@cache
def fluid(name, surface="rigid_lid", cuts=4):
    return PotentialFluid(subdivided(zones(name), cuts), WATER, surface, 0.0)


@cache
def ship(name, surface="rigid_lid", current=1.5):
    water = fluid(name, surface)
    outline = hull(name).outline
    mass = WATER.density * outline.area
    body = RigidBody(("surge", "heave", "pitch"), mass, 150 * mass, WATER.gravity, (0.4, -1.0))
    still = still_water(water.mesh.submesh, WATER)
    return ShipEnergy(body, still, water, 0.0 if surface == "zero_pressure" else current)


STEPS = 1e-2, 1e-2, 5e-4  # m, m, rad


def derivative(function, q):
    """d function/dq_k, k last, by central differences extrapolated twice: error h^6."""

    def central(factor):
        rates = []
        for k, step in enumerate(STEPS):
            e = np.zeros(3)
            e[k] = factor * step
            rates.append((function(q + e) - function(q - e)) / (2 * factor * step))
        return np.stack(rates, axis=-1)

    coarse, middle, fine = central(4), central(2), central(1)
    once = (4 * middle - coarse) / 3, (4 * fine - middle) / 3
    return (16 * once[1] - once[0]) / 15


def agree(exact, function, q):
    """Within 1e-8, and what solves to 1e-12 leave of a value divided by the step."""
    found, value = derivative(function, q), function(q)
    noise = 1e-12 * np.abs(value)[..., None] / np.array(STEPS)
    scale = np.abs(exact).max(axis=tuple(range(exact.ndim - 1)))
    return np.abs(found - exact) <= 1e-8 * scale + noise


@HULLS
@SURFACES
def test_slopes_are_the_derivatives_of_the_coefficients(name, surface):
    water = fluid(name, surface)
    slopes = water.slopes(Q)
    for part in ("a", "b", "c"):
        exact = getattr(slopes, part)
        assert np.all(
            agree(exact, lambda q, p=part: np.asarray(getattr(water.coefficients(q), p)), Q)
        )


@HULLS
def test_gradients_of_the_potential_and_the_mass_are_its_derivatives(name):
    vessel = ship(name)
    assert np.all(agree(vessel.gradient(Q), vessel.potential, Q))
    assert np.all(agree(vessel.mass_gradient(Q), vessel.mass, Q))
