"""One piston run, from the case to its dataset."""

from functools import partial

import numpy as np
import xarray as xr

from squat.coupling import Conserving, State, Step, march, repeated
from squat.piston.case import PistonCase
from squat.records import build
from squat.records.padding import padded
from squat.records.piston_kinds import PISTON


def steps(case: PistonCase) -> list[Step]:
    """All steps of the run; the last may be one that did not converge."""
    problem, coupling, dt, count = case.oscillator, case.coupling(), case.dt, case.time.steps
    start = State((problem.start(case.piston.initial_position, case.piston.initial_velocity),))
    if isinstance(coupling, Conserving):
        return list(repeated(partial(coupling.advance, dt=dt), start, count))
    return list(march(problem, coupling, start, dt, count))


def run(case: PistonCase) -> xr.Dataset:
    """Dataset of kind `piston`; `status` tells a run that ended early."""
    taken = steps(case)
    done = [step for step in taken if step.status == "converged"]
    failed = taken[len(done) :]
    problem = case.oscillator
    start = problem.start(case.piston.initial_position, case.piston.initial_velocity)
    motions = [start, *(step.state.motion for step in done)]
    position, velocity, acceleration = (
        np.concatenate(values) for values in zip(*motions, strict=True)
    )
    time = case.dt * np.arange(len(motions))
    data = {
        "time": time,
        "position": position,
        "velocity": velocity,
        "acceleration": acceleration,
        "exact_position": problem.exact(time, start),
        "kinetic_energy": problem.kinetic_energy(velocity),
        "potential_energy": problem.potential_energy(position),
        "iterations": [0, *(step.iterations for step in done)],
        "contraction": [np.nan, *(step.contraction for step in done)],
        "residual": padded([np.empty(0), *(step.residuals for step in done)]),
        "failed_residual": failed[0].residuals if failed else np.empty(0),
        "predicted_contraction": case.amplification(),
        "time_step": case.dt,
    }
    return build(PISTON, data, {"status": taken[-1].status, "scheme": case.scheme})
