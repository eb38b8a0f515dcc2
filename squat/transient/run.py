"""One coupled run, from the case to its dataset."""

from collections.abc import Iterator
from typing import Any, NamedTuple

import numpy as np
import xarray as xr

from squat.coupling import State, Step, march
from squat.fluid.curves import Curves
from squat.fluid.model import Flow
from squat.progress import progress
from squat.quantities import Vector
from squat.records import build
from squat.records.kinds import TRANSIENT
from squat.records.padding import padded
from squat.transient.audit import energies
from squat.transient.case import TransientCase
from squat.transient.factors import predicted_contraction
from squat.transient.parts import Parts, load_roots, prepare
from squat.transient.snapshots import fields


class Result(NamedTuple):
    """The record of a run and its snapshots (None where none were asked for)."""

    dataset: xr.Dataset
    fields: xr.Dataset | None


def run(case: TransientCase) -> Result:
    """Dataset of kind `transient`; a run that ends early says so in its `status`."""
    parts = prepare(case)
    first = start(case, parts)
    done: list[Step] = []
    failed: Step | None = None
    for step in progress(_steps(case, parts, first), total=case.time.steps, label="time steps"):
        if step.status != "converged":
            failed = step
            break
        done.append(step)
    states = [first, *(step.state for step in done)]
    dataset = _dataset(case, parts, states, done, failed)
    snapshots = fields(parts, states, case.snapshots) if case.snapshots else None
    return Result(dataset, snapshots)


def start(case: TransientCase, parts: Parts) -> State:
    """State at t = 0: at rest at w(0) in steady flow."""
    position = np.array([case.initial_heave])
    if case.coupling.start == "rest":
        motion, memory = parts.problem.at_rest(position)
    else:
        motion, memory = parts.problem.balanced(position, parts.dt)
    return State((motion,), memory)


def _steps(case: TransientCase, parts: Parts, first: State) -> Iterator[Step]:
    """Steps up to the end, to the first that does not converge, or to grounding."""
    least = case.grounding * parts.fluid.mesh.submesh.limits.clearance
    for step in march(parts.problem, parts.coupling, first, parts.dt, case.time.steps):
        yield step
        if step.status == "converged" and _clearance(parts, step.state) < least:
            return


def _clearance(parts: Parts, state: State) -> float:
    return parts.fluid.mesh.submesh.limits.clearance + float(state.motion.position[0])


def _status(case: TransientCase, parts: Parts, state: State, failed: Step | None) -> str:
    if failed is not None:
        return failed.status
    least = case.grounding * parts.fluid.mesh.submesh.limits.clearance
    return "grounded" if _clearance(parts, state) < least else "completed"


def _dataset(
    case: TransientCase, parts: Parts, states: list[State], done: list[Step], failed: Step | None
) -> xr.Dataset:
    heave, velocity, acceleration = (
        np.asarray(np.concatenate(values), float)
        for values in zip(*(state.motion for state in states), strict=True)
    )
    time = np.asarray(parts.dt * np.arange(len(states)), float)
    pressures, forces = _on_hull(parts, states)
    hull = parts.fluid.pressure.nodes
    points = parts.fluid.mesh.points[hull]
    curves = _curves(case, parts)
    roots = load_roots(case)
    data: dict[str, Any] = {
        "time": time,
        "phase": parts.omega * time,
        "heave": heave,
        "heave_velocity": velocity,
        "heave_acceleration": acceleration,
        "fluid_force": forces,
        "iterations": [0, *(step.iterations for step in done)],
        "contraction": [np.nan, *(step.contraction for step in done)],
        "residual": padded([np.empty(0), *(step.residuals for step in done)]),
        "failed_residual": failed.residuals if failed else np.empty(0),
        "failed_contraction": failed.contraction if failed else np.nan,
        **energies(case, time, heave, velocity, forces),
        "fluid_inertia": [curves.values(w)[2] for w in heave],
        "predicted_contraction": predicted_contraction(case, parts, curves, heave, velocity),
        "hull_pressure": pressures,
        "hull_x": points[:, 0],
        "hull_z": points[:, 1],
        "stable_root": roots.stable,
        "unstable_root": roots.unstable,
        "added_mass": parts.added_mass,
        "ship_mass": case.mass,
        "time_step": parts.dt,
        "omega": parts.omega,
    }
    attributes = {
        "status": _status(case, parts, states[-1], failed),
        "coupling": case.coupling.name,
        "current": case.current,
        "free_surface": case.free_surface,
    }
    return build(TRANSIENT, data, attributes)


def _curves(case: TransientCase, parts: Parts) -> Curves:
    limits = parts.fluid.mesh.submesh.limits
    low = (case.grounding / 2 - 1) * limits.clearance
    return Curves.of(parts.fluid, low, min(limits.draft / 2, limits.wall * 0.9))


def _on_hull(parts: Parts, states: list[State]) -> tuple[Vector, Vector]:
    """Pressure at the hull's nodes (time, hull_node), and the fluid's force (time,)."""
    fluid = parts.fluid
    rows, forces = [], []
    for state in states:
        motion, memory = state.motion, state.memory
        flow = Flow(motion.position, motion.velocity, memory.now)
        rows.append(fluid.pressure.nodal(flow, memory.rate, fluid.current))
        forces.append(fluid.force(flow, memory.rate)[0])
    return np.array(rows), np.array(forces)
