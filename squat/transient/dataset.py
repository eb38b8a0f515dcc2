"""The record of a run from its history."""

from typing import Any

import numpy as np
import xarray as xr

from squat.fluid.curves import Curves
from squat.quantities import Vector
from squat.records import build
from squat.records.kinds import TRANSIENT
from squat.transient.audit import audit, energies
from squat.transient.case import TransientCase
from squat.transient.factors import predicted_contraction
from squat.transient.history import Columns, History
from squat.transient.parts import Parts, curves, load_roots, ship_energy


def dataset(history: History) -> xr.Dataset:
    """Dataset of kind `transient`."""
    case, parts = history.case, history.parts
    columns = Columns.of(history.rows)
    heave, velocity, force = columns.position[:, 0], columns.velocity[:, 0], columns.force[:, 0]
    time = np.asarray(parts.dt * np.arange(len(heave)), float)
    water, roots = _curves(case, parts, float(heave.min())), load_roots(case)
    failed = history.failed
    data: dict[str, Any] = {
        "time": time,
        "phase": parts.omega * time,
        "heave": heave,
        "heave_velocity": velocity,
        "heave_acceleration": columns.acceleration[:, 0],
        "fluid_force": force,
        "iterations": columns.iterations,
        "contraction": columns.contraction,
        "residual": columns.residuals,
        "failed_residual": failed.residuals if failed else np.empty(0),
        "failed_contraction": failed.contraction if failed else np.nan,
        **energies(case, time, heave, velocity, force),
        "fluid_inertia": water.values(heave)[2],
        **audit(ship_energy(case, parts.fluid, water), columns),
        "predicted_contraction": predicted_contraction(case, parts, water, columns),
        **(_pressure(parts, columns) if case.model != "curves" else {}),
        "stable_root": roots.stable,
        "unstable_root": roots.unstable,
        "added_mass": parts.added_mass,
        "ship_mass": case.mass,
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
    }
    return build(TRANSIENT, data, attributes)


def _curves(case: TransientCase, parts: Parts, lowest: float) -> Curves:
    """Energy coefficients on the run's own mesh, whatever the run's force."""
    known = parts.problem.model
    return known if isinstance(known, Curves) else curves(case, parts.fluid, lowest)


def _pressure(parts: Parts, columns: Columns) -> dict[str, Vector]:
    points = parts.fluid.mesh.points[parts.fluid.pressure.nodes]
    return {"hull_pressure": columns.pressure, "hull_x": points[:, 0], "hull_z": points[:, 1]}
