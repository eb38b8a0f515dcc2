"""The record of a coupling with the user's own solver."""

from typing import Any, NamedTuple

import numpy as np
import xarray as xr

from squat.coupling import Step
from squat.dynamics import Motion
from squat.external.problem import BlackBox
from squat.quantities import Vector
from squat.records import build
from squat.records.coupling_kinds import COUPLED
from squat.records.padding import padded


class Masses(NamedTuple):
    """Added masses (n, n) [kg]: of the fluid, as estimated, and in the scheme, of the fluid; G."""

    effective: Vector
    used: Vector
    factor: float


def dataset(
    problem: BlackBox,
    start: Motion,
    taken: list[Step],
    masses: Masses,
    dt: float,
    modes: list[str],
    how: dict[str, Any],
) -> xr.Dataset:
    """Dataset of kind `coupled` from the steps `taken`; `how` becomes attributes."""
    done = [step for step in taken if step.status == "converged"]
    failed = taken[len(done) :]
    motions = [start, *(step.state.motion for step in done)]
    time = dt * np.arange(len(motions))
    forces = [
        step.force - problem.structure.force(step.state.motion, t)
        for step, t in zip(done, time[1:], strict=True)
    ]
    position, velocity, acceleration = (np.array(part) for part in zip(*motions, strict=True))
    data = {
        "time": time,
        "mode": modes,
        "mode_i": modes,
        "mode_j": modes,
        "position": position,
        "velocity": velocity,
        "acceleration": acceleration,
        "fluid_force": [np.full(len(modes), np.nan), *forces],
        "iterations": [0, *(step.iterations for step in done)],
        "contraction": [np.nan, *(step.contraction for step in done)],
        "residual": padded([np.empty(0), *(step.residuals for step in done)]),
        "failed_residual": failed[0].residuals if failed else np.empty(0),
        "failed_contraction": failed[0].contraction if failed else np.nan,
        "effective_added_mass": masses.effective,
        "added_mass": masses.used,
        "predicted_contraction": masses.factor,
        "time_step": dt,
    }
    status = failed[0].status if failed else "completed"
    return build(COUPLED, data, {"status": status, **how})
