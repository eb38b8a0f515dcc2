"""Still water by polygons: closed forms, areas by shapely, buoyancy as a gradient."""

import numpy as np
import pytest
from shapely import affinity
from shapely.geometry import Polygon, box

from squat.channel import moments
from squat.dynamics import RigidBody
from squat.dynamics.hydrostatics import Hydrostatics, heave_stiffness
from squat.water import Water
from tests.hulls import CHANNEL, NAMES, hull

WATER = Water(density=1025.0, gravity=9.7)
MODES = ("surge", "heave", "pitch")
Q = np.array([0.7, -2.0, 0.05])
HULLS = pytest.mark.parametrize("name", NAMES)


def still(name, modes=MODES):
    outline, up = hull(name).outline, np.array([0.0, CHANNEL.depth])
    return Hydrostatics(WATER, outline.vertices + up, outline.center + up, CHANNEL.depth, modes)


@HULLS
def test_heave_of_vertical_sides_is_a_spring(name):
    """U_h + m g w = rho g L w^2/2 beyond its value at rest, whatever lies below the walls."""
    water = still(name, ("heave",))
    weight = WATER.density * WATER.gravity * hull(name).outline.area
    spring = heave_stiffness(WATER, water.length)
    for w in (-3.0, 0.4):
        q = np.array([w])
        gain = water.potential(q) - water.rest[0] + weight * w
        assert gain == pytest.approx(spring * w**2 / 2, rel=1e-10)
        assert water.gradient(q) + weight == pytest.approx(spring * w, rel=1e-10)
        assert water.area_gradient(q) == pytest.approx(-water.length, rel=1e-12)


@HULLS
def test_moments_are_those_of_the_hull_cut_at_the_water_line(name):
    """By clipping the turned hull with its walls drawn upwards: another method."""
    water, outline = still(name), hull(name).outline
    high = np.array([0.0, 5.0])
    chain = water.chain
    raised = Polygon(np.vstack([chain[:1] + high, chain[1:-1], chain[-1:] + high]))
    turned = affinity.rotate(raised, Q[2], origin=tuple(water.center), use_radians=True)
    moved = affinity.translate(turned, Q[0], Q[1])
    wet = moved.intersection(box(-500, -500, 500, CHANNEL.depth))
    assert water.area(Q) == pytest.approx(wet.area, rel=1e-12)
    depth = CHANNEL.depth - wet.centroid.y
    expected = WATER.density * WATER.gravity * wet.area * depth
    assert water.potential(Q) == pytest.approx(expected, rel=1e-12)
    assert water.rest[1] == pytest.approx(outline.area, rel=1e-12)


@HULLS
def test_gradients_are_derivatives(name):
    water, h = still(name), 1e-3
    for value, slope in ((water.potential, water.gradient), (water.area, water.area_gradient)):
        found = [(value(Q + e) - value(Q - e)) / (2 * h) for e in h * np.eye(3)]
        # Cubic terms of the sliding water line at h^2, rounding at 1e-16 of the value over h.
        scale = np.abs(slope(Q)).max()
        assert slope(Q) == pytest.approx(found, rel=1e-5, abs=1e-7 * scale)


def test_pitch_stiffness_at_rest_is_that_of_the_water_plane():
    """About the centre of mass: rho g (L^3/12 - A (z_G - z_B))."""
    water, outline = still("lewis"), hull("lewis").outline
    mass = WATER.density * outline.area
    above = 0.8  # of the centre of mass over the centroid
    offset = tuple(outline.centroid - outline.center + np.array([0.0, above]))
    body = RigidBody(MODES, mass, 1.0, WATER.gravity, offset)

    def moment(angle):
        q = np.array([0.0, 0.0, angle])
        return (water.gradient(q) + mass * WATER.gravity * body.height_gradient(q))[2]

    h = 1e-4
    stiffness = (moment(h) - moment(-h)) / (2 * h)
    area, _ = moments(outline.vertices)
    inertia = water.length**3 / 12
    expected = WATER.density * WATER.gravity * (inertia - area * above)
    assert stiffness == pytest.approx(expected, rel=1e-6)


def test_mass_matrix_is_the_kinetic_energy_of_a_turning_body():
    body = RigidBody(MODES, 3.0, 40.0, 9.81, (0.5, -1.5))
    velocity, h = np.array([0.3, -0.2, 0.7]), 1e-6

    def center(q):
        cos, sin = np.cos(q[2]), np.sin(q[2])
        return q[:2] + np.array([[cos, -sin], [sin, cos]]) @ [0.5, -1.5]

    speed = (center(Q + h * velocity) - center(Q - h * velocity)) / (2 * h)
    own = 40.0 - 3.0 * (0.5**2 + 1.5**2)
    energy = (3.0 * speed @ speed + own * velocity[2] ** 2) / 2
    assert velocity @ body.mass_matrix(Q) @ velocity / 2 == pytest.approx(energy, rel=1e-9)
    e = np.array([0, 0, h])
    slope = (body.mass_matrix(Q + e) - body.mass_matrix(Q - e)) / (2 * h)
    assert body.mass_gradient(Q)[:, :, 2] == pytest.approx(slope, abs=1e-8)


@pytest.mark.parametrize("modes", [("heave",), ("heave", "pitch"), ("surge", "heave"), MODES])
def test_fewer_modes_are_a_part_of_all(modes):
    place = [MODES.index(mode) for mode in modes]
    q = np.zeros(3)
    q[place] = Q[place]
    part, whole = still("v", modes), still("v")
    assert part.potential(q[place]) == whole.potential(q)
    assert np.array_equal(part.gradient(q[place]), whole.gradient(q)[place])
    bodies = [RigidBody(m, 3.0, 40.0, 9.81, (0.5, -1.5)) for m in (modes, MODES)]
    few, every = (body.mass_matrix(x) for body, x in zip(bodies, (q[place], q), strict=True))
    assert np.array_equal(few, every[np.ix_(place, place)])


@HULLS
def test_stiffness_is_the_second_derivative_about_any_point(name):
    outline, up = hull(name).outline, np.array([0.0, CHANNEL.depth])
    center = outline.center + up + np.array([1.7, -0.6])
    water = Hydrostatics(WATER, outline.vertices + up, center, CHANNEL.depth, MODES)
    h = 1e-4
    found = [(water.gradient(e) - water.gradient(-e)) / (2 * h) for e in h * np.eye(3)]
    assert found == pytest.approx(water.stiffness, rel=1e-6, abs=1e-6 * water.stiffness.max())


def test_a_body_turns_about_its_centre_of_mass_unless_told_otherwise():
    body = RigidBody(MODES, 4.0, 9.0, 9.8)
    assert body.mass_matrix(Q) == pytest.approx(np.diag([4.0, 4.0, 9.0]), abs=1e-14)
    assert body.potential(Q) == pytest.approx(4.0 * 9.8 * Q[1])


def test_weight_and_mooring_pull_as_their_energy_falls():
    body = RigidBody(MODES, 4.0, 9.0, 9.8, offset=(0.4, -0.7), mooring=30.0)
    h = 1e-5
    found = [(body.potential(Q + e) - body.potential(Q - e)) / (2 * h) for e in h * np.eye(3)]
    assert body.gradient(Q) == pytest.approx(found, rel=1e-8)
    assert body.potential(np.array([0.5, 0.0, 0.0])) == pytest.approx(30.0 * 0.5**2 / 2)
