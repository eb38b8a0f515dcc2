"""The record of a run from its history."""

from typing import Any

import numpy as np
import xarray as xr

from squat.fluid.curves import Curves
from squat.fluid.model import EnergyModel, Noted
from squat.mesh import MODES
from squat.quantities import Vector
from squat.records import build
from squat.records.added_mass_kinds import entry_units
from squat.records.transient_kinds import TRANSIENT
from squat.transient.audit import audit, energies
from squat.transient.case import TransientCase
from squat.transient.factors import predicted_contraction
from squat.transient.history import Columns, History
from squat.transient.inputs import load_roots
from squat.transient.landscape import landscape
from squat.transient.parts import Parts, curves, ship_energy

_FORCES = {"surge": "surge_force", "heave": "fluid_force", "pitch": "pitch_moment"}


def dataset(history: History) -> xr.Dataset:
    """Dataset of kind `transient`."""
    case, parts = history.case, history.parts
    columns = Columns.of(history.rows)
    time = np.asarray(parts.dt * np.arange(len(history.rows)), float)
    water, roots = _water(case, parts, columns.position), load_roots(case)
    failed = history.failed
    data: dict[str, Any] = {
        "time": time,
        "phase": parts.omega * time,
        **_motion(case, columns),
        "clearance": [parts.fluid.mesh.submesh.clearance(q) for q in columns.position],
        "iterations": columns.iterations,
        "contraction": columns.contraction,
        "residual": columns.residuals,
        "failed_residual": failed.residuals if failed else np.empty(0),
        "failed_contraction": failed.contraction if failed else np.nan,
        **energies(case, parts, time, columns),
        "fluid_inertia": _inertia(water, columns.position, case.place),
        **audit(ship_energy(case, parts.fluid, water), columns),
        **landscape(case, water),
        "predicted_contraction": predicted_contraction(case, parts, water, columns),
        **(_pressure(parts, columns) if case.model != "curves" else {}),
        "stable_root": roots.stable,
        "unstable_root": roots.unstable,
        "center": parts.fluid.mesh.submesh.motion.center,
        "axis": ["x", "z"],
        "mode_i": list(case.modes),
        "mode_j": list(case.modes),
        "entry_units": entry_units(case.modes),
        "added_mass_matrix": parts.added_mass,
        "added_mass": parts.added_mass[case.place, case.place],
        "ship_mass": case.mass,
        "ship_inertia": parts.problem.body.inertia,
        "time_step": parts.dt,
        "omega": parts.omega,
    }
    attributes = {
        "status": history.status,
        "coupling": case.coupling.name,
        "current": case.current,
        "free_surface": case.free_surface,
        "force": case.force,
        "model": case.model,
        "modes": " ".join(case.modes),
    }
    return build(TRANSIENT, data, attributes)


def _water(case: TransientCase, parts: Parts, positions: Vector) -> EnergyModel:
    """Energy coefficients on the run's own mesh, whatever the run's force."""
    known = parts.problem.model
    if isinstance(known, Curves):
        return known
    if len(case.modes) == 1:
        return curves(case, parts.fluid, float(positions.min()))
    parts.forget()  # a restarted run has not asked what an undisturbed one has
    return Noted(parts.fluid)


def _inertia(water: EnergyModel, positions: Vector, heave: int) -> Vector:
    if isinstance(water, Curves):
        return np.asarray(water.values(positions[:, 0])[2])
    return np.array([water.coefficients(q).c[heave, heave] for q in positions])


def _motion(case: TransientCase, columns: Columns) -> dict[str, Vector]:
    """Position, velocity, acceleration and force by mode; zero where the ship has no such mode."""
    data: dict[str, Vector] = {}
    rates = ("", "_velocity", "_acceleration")
    for mode in MODES:
        if mode not in case.modes:
            data |= {mode + rate: np.zeros(len(columns.position)) for rate in rates}
            continue
        place = case.modes.index(mode)
        data |= {
            mode + rate: column[:, place] for rate, column in zip(rates, columns[:3], strict=True)
        }
        data[_FORCES[mode]] = columns.force[:, place]
    return data


def _pressure(parts: Parts, columns: Columns) -> dict[str, Vector]:
    points = parts.fluid.mesh.points[parts.fluid.pressure.nodes]
    return {"hull_pressure": columns.pressure, "hull_x": points[:, 0], "hull_z": points[:, 1]}
