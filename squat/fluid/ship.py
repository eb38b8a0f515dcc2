"""The ship of a hull: a rigid body that turns about its centre of gravity."""

import numpy as np

from squat.channel import Hull
from squat.dynamics import RigidBody
from squat.dynamics.hydrostatics import Hydrostatics
from squat.errors import InputError
from squat.fluid.energy import still_water
from squat.mesh import Mesh, Submesh
from squat.quantities import Vector
from squat.water import Water

LOADING = ("gravity_center", "gyradius")
"""Keys of a hull that neither its mesh nor its flow depends on."""


def rigid_body(hull: Hull, water: Water, modes: tuple[str, ...], mooring: float = 0.0) -> RigidBody:
    """Mass of the displaced water, with its inertia about the centre of gravity."""
    mass = water.density * hull.outline.area
    inertia = mass * hull.radius_of_gyration**2
    return RigidBody(modes, mass, inertia, water.gravity, mooring=mooring)


def about_gravity(mesh: Mesh, hull: Hull) -> Mesh:
    """`mesh` with pitch about the centre of gravity of `hull`, which makes M_s constant."""
    return mesh.about(center_of_gravity(mesh.submesh, hull))


def center_of_gravity(submesh: Submesh, hull: Hull) -> Vector:
    """Centre of gravity of `hull` in the coordinates of `submesh` at rest, shape (2,) [m]."""
    return np.asarray(hull.center_of_gravity + np.array([0.0, submesh.motion.level]))


def about_another_point(matrix: Vector, shift: Vector) -> Vector:
    """Added-mass matrix (3, 3) of surge, heave, pitch about a point moved by `shift` (2,) [m].

    V_pitch about c + shift is V_pitch about c, plus shift_z in surge and -shift_x in heave.
    """
    change = np.eye(3)
    change[2, :2] = shift[1], -shift[0]
    return np.asarray(change @ matrix @ change.T)


def check_stability(submesh: Submesh, body: RigidBody, water: Water) -> Hydrostatics:
    """Still water around the ship; raises InputError where it would capsize at rest."""
    still = still_water(submesh, water)
    if "pitch" in body.modes:
        stiffness = float(still.stiffness[-1, -1])
        if stiffness <= 0:
            raise InputError(
                f"hull.gravity_center: so high that the ship turns over in still water (pitch "
                f"stiffness {stiffness:.4g} N m/m); lower it"
            )
    return still
