"""The solver that remembers: right wherever the ship goes, and cheap where it goes slowly."""

import numpy as np

from squat.channel import Channel, Rectangle
from squat.fem import AffineStiffness
from squat.fluid.stiffness import TOLERANCE, MovingSolver
from squat.mesh import subdivided, submesh

CHANNEL = Channel(depth=20.0, upstream=40.0, downstream=60.0)


def test_small_motions_share_a_factor_and_all_answers_solve_their_system():
    mesh = subdivided(submesh(Rectangle(length=40.0, draft=10.0), CHANNEL, ("heave",)), 6)
    affine = AffineStiffness.on(mesh)
    solver = MovingSolver(affine, affine.space.dofs("In"))
    load = np.random.default_rng(4).normal(size=affine.space.size)
    places = [np.array([w]) for w in (0.0, -0.01, -0.02, -0.03, -9.0)]
    for count, q in enumerate(places, 1):
        x = solver.solve(affine.theta(q), load)
        rest = (affine.at(q) @ x - load)[solver.free]
        assert np.linalg.norm(rest) < 10 * TOLERANCE * np.linalg.norm(load)
        assert solver.solves == count
        assert solver.factorisations == (1 if count < len(places) else 2)
