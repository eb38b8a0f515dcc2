"""The water's force: hydrostatics, steady flow, inertia, and the solver behind it."""

import numpy as np
import pytest

from squat.errors import InputError
from squat.fem import Factorised
from squat.fluid.matching import RectangleReference, rigid_modes
from squat.fluid.model import Flow
from squat.mesh import PositionError


@pytest.mark.parametrize("w", [-3.0, 0.0, 2.0])
def test_still_water_gives_hydrostatics_exactly(fluid, at, w):
    water = fluid("current=0")
    flow = water.flow(at(w), at(0))
    still = np.zeros_like(flow.potential)
    assert water.force(flow, still) == pytest.approx(1000 * 9.81 * 40 * (10 - w), rel=1e-12)


def test_no_hull_motion_and_no_current_is_no_flow(fluid, at):
    water = fluid("current=0")
    assert np.abs(water.flow(at(-1), at(0)).potential).max() == 0


def test_unsteady_pressure_of_unit_acceleration_is_the_energys_inertia(fluid, at):
    """-int rho phi_2 n_z ds = -rho phi_2^T K phi_2: m_f from the force response."""
    water = fluid("current=1.5")
    for w in (-4.0, 0.0, 1.0):
        flow = water.flow(at(w), at(0.3))
        _, unit = water.unit_potentials(at(w))
        response = water.force(flow, unit[0]) - water.force(flow, np.zeros_like(unit[0]))
        assert -response[0] == pytest.approx(water.coefficients(at(w)).c[0, 0], rel=1e-10)


def test_coefficients_approach_the_reference_from_below(fluid, at):
    reference = RectangleReference(40.0, 10.0, 20.0, 40.0, 60.0, "rigid_lid")
    modes = {"heave": rigid_modes(0, 0)["heave"]}
    exact_c = 1000 * reference.added_mass(modes)[0, 0]
    exact_a, _ = reference.current(modes)
    for mesh, slack in (("coarse", 0.02), ("paper", 0.003)):
        found = fluid(f"mesh={mesh}").coefficients(at(0))
        assert 1 - slack < found.c[0, 0] / exact_c < 1
        assert 1 - slack < found.a / (1000 * exact_a) < 1


def test_steady_force_lies_between_the_1d_and_the_exact_value(fluid, at):
    """P1 pressure integration misses part of the corners' suction (h^(1/3))."""
    water = fluid("mesh=paper", "current=1")
    flow = water.flow(at(0), at(0))
    net = water.force(flow, np.zeros_like(flow.potential))[0] - 1000 * 9.81 * 400

    def energy(w):
        return RectangleReference(40.0, 10 - w, 20.0, 40.0, 60.0, "rigid_lid").current({})[0]

    h = 0.02
    slope = (8 * (energy(h) - energy(-h)) - energy(2 * h) + energy(-2 * h)) / (12 * h)
    exact = 1000 * slope / 2 + 1000 * 40 / 2
    one_dimensional = 1000 * 40 / 2 * (1 - 4)
    assert exact < net < one_dimensional
    assert net == pytest.approx(exact, rel=0.04)


def test_force_is_quadratic_in_current_and_velocity(fluid, at):
    """F - hydrostatics scales with the square of all speeds at steady potential."""
    forces = []
    for factor in (1.0, 2.0):
        water = fluid(f"current={factor}")
        flow = water.flow(at(-2), at(0.1 * factor))
        still = np.zeros_like(flow.potential)
        forces.append(water.force(flow, still)[0] - 1000 * 9.81 * 40 * 12)
    assert forces[1] == pytest.approx(4 * forces[0], rel=1e-9)


def test_moving_solver_is_the_direct_solution_wherever_it_came_from(fluid, at):
    water = fluid("current=2")
    for w in (0.0, -0.01, -0.5, -5.0, 3.0, -9.0):
        flow = water.flow(at(w), at(0.2))
        theta = water._affine.theta(at(w))
        direct = Factorised.of(water._affine.matrix(theta), water.space.dofs("In"))
        load = 2 * water.inflow + 0.2 * water._loads.at(at(w))[0]
        exact = direct.solve(load).values
        assert np.abs(flow.potential - exact).max() < 1e-10 * np.abs(exact).max()
    assert water._lid.factorisations < water._lid.solves


def test_positions_out_of_reach_are_refused(fluid, at):
    water = fluid()
    with pytest.raises(PositionError):
        water.flow(at(-9.99), at(0))
    with pytest.raises(PositionError):
        water.flow(at(6), at(0))


def test_zero_pressure_with_a_current_is_refused_by_name(fluid):
    with pytest.raises(InputError, match=r"free_surface=zero_pressure: no current=1 reaches"):
        fluid("free_surface=zero_pressure", "current=1")


def test_blend_takes_the_current_from_the_lid_and_the_motion_from_zero_pressure(fluid, at):
    lid, zero = fluid("current=2"), fluid("current=0", "free_surface=zero_pressure")
    blend = fluid("current=2", "free_surface=blend")
    mixed = blend.flow(at(-1), at(0.3)).potential
    parts = lid.flow(at(-1), at(0)).potential + zero.flow(at(-1), at(0.3)).potential
    assert mixed == pytest.approx(parts, abs=1e-9 * np.abs(parts).max())
    assert np.all(blend.coefficients(at(0)).b == 0)


def test_pressure_at_the_nodes_integrates_to_the_force(fluid, at):
    water = fluid("current=1")
    flow = water.flow(at(-1), at(0.2))
    rate = 0.1 * flow.potential
    nodal = water.pressure.nodal(Flow(*flow), rate, 1.0)
    nodes = water.pressure.nodes
    points = water.mesh.moved(at(-1))[nodes]
    keel = points[:, 1] <= points[:, 1].min() + 1e-9
    force = np.trapezoid(nodal[keel], points[keel, 0])
    # Averaging at nodes smears the corners' suction over one element.
    assert force == pytest.approx(water.force(flow, rate)[0], rel=2e-3)
