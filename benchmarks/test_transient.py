"""The default coupled run against the plain way, both on one core in one run."""

import time
from dataclasses import replace

import numpy as np
from scipy.sparse.linalg import splu

from squat.config import compose, validate
from squat.coupling import march
from squat.fluid.model import Flow
from squat.fluid.potential import PotentialFluid
from squat.transient.parts import prepare
from squat.transient.run import start


class PlainFluid(PotentialFluid):
    """scikit-fem assembly on the moved mesh and a fresh scipy factorisation at each iteration."""

    def flow(self, position, velocity):
        space = self.space.at(self.mesh.moved(position))
        free = self._lid.free
        matrix = space.stiffness()[free][:, free].tocsc()
        load = self.current * self.inflow + velocity @ self._loads.at(position)
        potential = np.zeros(len(load))
        potential[free] = splu(matrix).solve(load[free])
        return Flow(position, velocity, potential)


def history(parts, case):
    first = start(case, parts)
    began = time.perf_counter()
    steps = list(march(parts.problem, parts.coupling, first, parts.dt, case.time.steps))
    seconds = time.perf_counter() - began
    return np.array([step.state.motion.position[0] for step in steps]), seconds


def test_default_run_is_at_least_six_times_faster_than_the_plain_way(note):
    case = validate(compose("transient", "current=1")).case
    fast = prepare(case)
    fluid = fast.fluid
    plain_fluid = PlainFluid(fluid.mesh, fluid.water, fluid.free_surface, fluid.current)
    plain = replace(fast, problem=replace(fast.problem, fluid=plain_fluid))
    fluid.flow(np.array([0.0]), np.array([0.0]))  # set-up is not the run's
    w_fast, t_fast = history(fast, case)
    w_plain, t_plain = history(plain, case)
    solver = fluid._lid
    note("plain over fast run", f"{t_plain / t_fast:.1f}", "6")
    note("its factorisations for solves", f"{solver.factorisations} for {solver.solves}")
    assert np.abs(w_fast - w_plain).max() < 1e-9
    assert t_plain / t_fast > 6
