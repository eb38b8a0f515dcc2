"""The variational force: derivatives, reciprocity, exact values, what pressure must agree with."""

from dataclasses import replace
from functools import cache

import numpy as np
import pytest

from squat.dynamics import Motion, RigidBody
from squat.fluid.energy import ShipEnergy, still_water
from squat.fluid.matching import RectangleReference
from squat.fluid.model import Flow
from squat.fluid.potential import PotentialFluid
from squat.fluid.variational import gyroscopic
from squat.mesh import subdivided, submesh
from squat.water import Water
from tests.hulls import CHANNEL, NAMES, hull, zones

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


@HULLS
def test_current_and_motion_exchange_their_loads(name):
    """b_j = rho r_j.phi_0 = rho r_0.phi_j, and c is symmetric before it is made so."""
    water = fluid(name)
    flows = water.unit_flows(Q)
    b = water.coefficients(Q).b
    assert flows.unit @ water.inflow * WATER.density == pytest.approx(b, rel=1e-9)
    raw = flows.loads @ flows.unit.T
    assert raw == pytest.approx(raw.T, rel=1e-9, abs=1e-10 * np.abs(raw).max())


@HULLS
def test_ship_that_keeps_up_with_the_current_leaves_it_uniform(name):
    """phi_0 + phi_surge = x - x_In, exactly, so b_surge + a is constant and b_surge' = -a'."""
    water = fluid(name)
    flows = water.unit_flows(Q)
    x = water.mesh.moved(Q)[:, 0]
    assert flows.current + flows.unit[0] == pytest.approx(x - x.min(), abs=1e-9 * np.ptp(x))
    slopes = water.slopes(Q)
    assert slopes.b[0] == pytest.approx(-slopes.a, rel=1e-8, abs=1e-9 * np.abs(slopes.a).max())


def test_gyroscopic_force_is_what_a_galilean_observer_expects():
    """Heave force F1 (V - u)^2 at surge velocity u, F1 = (da/dw + rho L)/2: Gam = 2 V F1."""
    gaps = []
    for cuts in (4, 8, 16):
        slopes = fluid("rectangle", cuts=cuts).slopes(np.zeros(3))
        force = (slopes.a[1] + WATER.density * 40.0) / 2
        gaps.append(abs(gyroscopic(slopes, 1.5)[0, 1] / (2 * 1.5 * force) - 1))
    assert np.all(np.array(gaps[1:]) < 0.65 * np.array(gaps[:-1]))
    assert gaps[-1] < 1e-3


def integrated(water, q, current, motion, current_rate):
    """Force by pressure: d phi/dt at the nodes by the chain rule, its slopes by differences."""
    h, (velocity, acceleration) = 1e-3, motion
    flows = water.unit_flows(q)
    potential = current * flows.current + velocity @ flows.unit
    rate = current_rate * flows.current + acceleration @ flows.unit
    for speed, e in zip(velocity, h * np.eye(3), strict=True):
        ahead, behind = water.unit_flows(q + e), water.unit_flows(q - e)
        rate = rate + speed * current * (ahead.current - behind.current) / (2 * h)
        rate = rate + speed * velocity @ (ahead.unit - behind.unit) / (2 * h)
    return water.pressure.force(Flow(q, velocity, potential), rate, current)


ZERO, (SURGE, HEAVE, PITCH) = np.zeros(3), np.eye(3)
MOTIONS = [
    (1.0, ZERO, ZERO, 0.0),
    (1.0, ZERO, ZERO, 0.5),
    # Surge at half the current: at the current's own speed there is no force at all.
    *((1.0, s * u, ZERO, 0.0) for u in (SURGE / 2, HEAVE, PITCH / 10) for s in (1, -1)),
    *((0.0, u, ZERO, 0.0) for u in (SURGE, HEAVE, PITCH / 10)),
    *((0.0, u, ZERO, 0.0) for u in (SURGE + HEAVE, HEAVE + PITCH / 10)),
    *((0.0, ZERO, u, 0.0) for u in (SURGE, HEAVE, PITCH)),
]


def test_pressure_of_a_smooth_hull_has_the_same_force_term_by_term():
    """Both discretisations approach each other; no term of Q_i, no sign, can be missing."""
    q, gaps = np.array([0.0, -1.0, 0.02]), []
    for cuts in (8, 16):
        water = fluid("half_ellipse", cuts=cuts)
        vessel = replace(ship("half_ellipse"), model=water)
        still = -vessel.hydrostatics.gradient(q)
        worst = []
        for current, velocity, acceleration, rate in MOTIONS:
            motion = Motion(q, velocity, acceleration)
            found = vessel.at_current(current).water_force(motion, rate) - still
            pressure = integrated(water, q, current, motion[1:], rate) - still
            worst.append(np.abs(pressure - found).max() / np.abs(found).max())
        gaps.append(np.array(worst))
    assert np.all(gaps[1] < np.maximum(gaps[0] / 1.5, 1e-11))
    assert np.max(gaps[1]) < 0.01


@cache
def reference():
    """Exact steady heave force of the section 3.6 rectangle at unit current [N/m]."""

    def a(w):
        return RectangleReference(40.0, 10 - w, 20.0, 40.0, 60.0, "rigid_lid").current({})[0]

    h = 0.02
    slope = (8 * (a(h) - a(-h)) - a(2 * h) + a(-2 * h)) / (12 * h)
    return 1000 * (slope + 40) / 2


def steady(water):
    """Heave force by energy and by pressure at rest in unit current, without still water."""
    q = np.zeros(1)
    flow = replace(water, current=1.0).flow(q, q)
    still = np.zeros_like(flow.potential)
    pressure = water.pressure.force(flow, still, 1.0)[0] - 1000 * 9.81 * 400
    return (water.slopes(q).a[0] + 1000 * 40) / 2, pressure


def test_steady_force_converges_like_the_energy_and_pressure_like_the_corners():
    """Uniform meshes: |grad phi|^2 ~ r^(-2/3) makes energies h^(4/3) and pressures h^(1/3)."""
    errors = []
    for cuts in (8, 16, 32):
        mesh = subdivided(submesh(hull("rectangle"), CHANNEL, ("heave",)), cuts)
        found = steady(PotentialFluid(mesh, WATER, "rigid_lid", 0.0))
        errors.append(np.abs(np.array(found) - reference()))
    orders = np.log2(np.array(errors[:-1]) / errors[1:])
    assert orders[-1, 0] == pytest.approx(4 / 3, abs=0.12)
    assert orders[-1, 1] == pytest.approx(1 / 3, abs=0.15)
    assert errors[-1][0] < errors[-1][1] / 8


def test_steady_force_on_the_papers_mesh_is_exact_to_three_in_a_thousand(case):
    from squat.transient.inputs import load_mesh

    ship_case = case("transient")
    water = PotentialFluid(load_mesh(ship_case), ship_case.water, "rigid_lid", 0.0)
    energy, pressure = steady(water)
    assert energy == pytest.approx(reference(), rel=3e-3)
    assert abs(pressure - reference()) > 10 * abs(energy - reference())
