"""Energy over heave at a run's current: what its phase portrait is drawn from."""

from typing import Any

from squat.fluid.curves import Curves
from squat.fluid.model import EnergyModel
from squat.stability.heave import HeaveSystem
from squat.stability.portrait import highest_pair
from squat.transient.case import TransientCase

POINTS = 201
"""Samples of each curve: cubic interpolation between them is good to 1e-6 of U's range."""


def landscape(case: TransientCase, water: EnergyModel) -> dict[str, Any]:
    """M(w) and U(w) of E = M w'^2/2 + U, and the equilibria of U; nothing for several modes."""
    if not isinstance(water, Curves):
        return {}
    mode = HeaveSystem.of(case.hull, case.water, water).at_current(case.current)
    heave = mode.interval.grid(POINTS)
    stable, unstable = highest_pair(mode)
    return {
        "curve_heave": heave,
        "curve_inertia": mode.mass(heave),
        "curve_potential": mode.potential(heave),
        "stable_equilibrium": stable,
        "unstable_equilibrium": unstable,
    }
