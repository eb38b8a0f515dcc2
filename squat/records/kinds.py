"""Every kind of dataset that squat writes, by name."""

from squat.records.added_mass_kinds import ADDED_MASS, INERTIA, SENSITIVITY
from squat.records.bottom_kinds import UNEVEN_BOTTOM
from squat.records.coupling_kinds import COUPLED, RACE
from squat.records.fleet_kinds import STABILITY_MAP
from squat.records.mesh_kinds import MESH
from squat.records.piston_kinds import ITERATIONS, PISTON
from squat.records.reduced_kinds import REDUCED
from squat.records.stability_kinds import (
    CONVERGENCE,
    EQUILIBRIA,
    HULL_SHAPES,
    LIMITS,
    LIMITS_MAP,
    STABILITY,
)
from squat.records.sweep import SWEEP
from squat.records.transient_kinds import TRANSIENT
from squat.records.trim_kinds import TRIM

_ALL = (
    PISTON,
    ITERATIONS,
    EQUILIBRIA,
    MESH,
    ADDED_MASS,
    INERTIA,
    SENSITIVITY,
    TRANSIENT,
    COUPLED,
    REDUCED,
    STABILITY,
    LIMITS,
    LIMITS_MAP,
    HULL_SHAPES,
    CONVERGENCE,
    RACE,
    SWEEP,
    STABILITY_MAP,
    TRIM,
    UNEVEN_BOTTOM,
)
KINDS = {kind.name: kind for kind in _ALL}
