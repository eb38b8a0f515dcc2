"""Flow and pressure of a trial motion: superposition, scaling, answers kept and forgotten."""

import numpy as np
import pytest

from squat.errors import InputError
from squat.fluid import sensitivity
from squat.fluid.accuracy import accurate
from squat.fluid.energy import Energies
from squat.fluid.model import Coefficients, Noted, Slopes, forget
from squat.fluid.potential import PotentialFluid
from squat.fluid.ship import about_another_point, about_gravity, check_stability, rigid_body
from squat.mesh import subdivided
from squat.water import Water
from tests.hulls import hull, zones

WATER = Water(density=1000.0, gravity=9.81)
Q, SPEED = np.array([0.5, -1.5, 0.02]), np.array([0.3, -0.2, 0.01])
SURFACES = pytest.mark.parametrize("surface", ["rigid_lid", "blend"])


def water(surface="rigid_lid", current=2.0, name="lewis"):
    return PotentialFluid(subdivided(zones(name), 3), WATER, surface, current)


@SURFACES
@pytest.mark.parametrize("current", [0.0, 2.0])
def test_flow_is_the_sum_of_unit_flows(surface, current):
    fluid = water(surface, current)
    steady, moving = fluid.unit_potentials(Q)
    flow = fluid.flow(Q, SPEED)
    expected = current * steady + SPEED @ moving
    assert flow.potential == pytest.approx(expected, abs=1e-8 * np.abs(expected).max())


def test_steady_suction_grows_with_the_square_of_the_current():
    forces = []
    for current in (0.0, 1.0, 3.0):
        fluid = water(current=current)
        flow = fluid.flow(Q, np.zeros(3))
        forces.append(fluid.force(flow, np.zeros_like(flow.potential)))
    still, slow, fast = forces
    assert fast - still == pytest.approx(9 * (slow - still), rel=1e-7)
    assert slow[1] < still[1]


def test_a_fluid_that_forgot_answers_as_a_new_one_to_the_bit():
    used = water()
    for w in (-0.5, -1.0, 0.2):
        used.flow(np.array([0.0, w, 0.0]), SPEED)
    forget(used)
    assert np.array_equal(used.flow(Q, SPEED).potential, water().flow(Q, SPEED).potential)
    forget(object())


def test_each_position_is_asked_for_once():
    asked = []

    class Model:
        free_surface = "rigid_lid"

        def coefficients(self, position):
            asked.append(("coefficients", *position))
            return Coefficients(position[0], position, np.outer(position, position))

        def slopes(self, position):
            asked.append(("slopes", *position))
            return Slopes(position, position, position)

    noted = Noted(Model())
    for _ in range(2):
        for w in (1.0, 2.0):
            assert noted.coefficients(np.array([w])).a == w
            assert noted.slopes(np.array([w])).a == w
    assert asked == [(what, w) for w in (1.0, 2.0) for what in ("coefficients", "slopes")]
    assert noted.free_surface == "rigid_lid"


def test_total_energy_is_the_sum_of_its_parts():
    parts = Energies(ship=1.0, water=20.0, static=300.0, stream=4000.0, supply=5e4, power=6e5)
    assert parts.total == 4321.0


def test_added_mass_about_another_point_gives_the_same_energy():
    """A hull turning about c + shift moves as one turning about c that shifts as well."""
    half = np.array([[2.0, 0.0, 0.0], [0.3, 3.0, 0.0], [-1.0, 4.0, 7.0]])
    matrix, shift = half @ half.T, np.array([2.0, -0.5])
    theta = 0.1
    about_c = np.array([shift[1] * theta, -shift[0] * theta, theta])
    moved = about_another_point(matrix, shift)
    assert moved[2, 2] * theta**2 == pytest.approx(about_c @ matrix @ about_c)
    assert moved[:2, :2] == pytest.approx(matrix[:2, :2])
    back = about_another_point(moved, -shift)
    assert back == pytest.approx(matrix)


def test_a_ship_turns_about_its_centre_of_gravity():
    mesh, ship = subdivided(zones("rectangle"), 2), hull("rectangle")
    center = about_gravity(mesh, ship).submesh.motion.center
    assert center == pytest.approx(
        [ship.center_of_gravity[0], ship.center_of_gravity[1] + mesh.submesh.motion.level]
    )


def test_a_ship_that_stands_is_told_from_one_that_turns_over():
    modes = "surge", "heave", "pitch"
    body = rigid_body(hull("rectangle"), WATER, modes)
    mesh = subdivided(zones("rectangle"), 2)
    still = check_stability(mesh.submesh, body, WATER)
    assert still.stiffness[-1, -1] > 0
    high = mesh.about(mesh.submesh.motion.center - np.array([0.0, 500.0]))
    assert check_stability(high.submesh, body, WATER).stiffness[-1, -1] > 0
    low = mesh.about(mesh.submesh.motion.center + np.array([0.0, 500.0]))
    with pytest.raises(InputError, match=r"hull\.gravity_center: so high"):
        check_stability(low.submesh, body, WATER)


def test_recommendations_are_the_first_that_stay_within_the_tolerance(case):
    keys = "sizes=[1.6,0.8,0.4]", "distances=[10,40,160]", "tolerance=0.02", "accuracy.near=0.32"
    asked = case("sensitivity", *keys)
    data = sensitivity.run(asked)
    exact = accurate(asked.hull, asked.channel, asked.accuracy, "zero_pressure").value[1, 1]
    limit = float(data["size_limit"])
    assert limit == pytest.approx(exact / (np.pi * (asked.hull.length / 2) ** 2), rel=1e-12)
    for names, reference, advice in (
        ("size", limit, "recommended_size"),
        ("distance", float(data["distance_inertia_coefficient"][-1]), "recommended_distance"),
    ):
        found = data[f"{names}_inertia_coefficient"].values.reshape(-1, 3)[0]
        good = np.abs(found / reference - 1) <= 0.02
        inside = [bool(good[n:].all()) for n in range(3)]
        expected = float(data[names][inside.index(True)]) if any(inside) else np.nan
        assert float(data.attrs[advice]) == pytest.approx(expected, nan_ok=True)
    assert (np.diff(data["size_nodes"].values) > 0).all()
