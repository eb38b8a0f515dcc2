"""Energy over heave of a run, from its record: E = M(w) w'^2/2 + U(w)."""

from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from scipy.interpolate import CubicSpline

from squat.quantities import Vector
from squat.replay.runs import Run

NEEDS = (
    "heave",
    "heave_velocity",
    "fluid_inertia",
    "initial_energy",
    "energy_residual",
    "curve_heave",
    "curve_inertia",
    "curve_potential",
    "stable_equilibrium",
    "unstable_equilibrium",
)
"""What a record must hold; those of several modes do not."""

_AROUND = 4.0  # ranges of the motion that are shown on either side of it, at most
_MARGIN = 0.08
_POINTS = 200


@dataclass(frozen=True, eq=False)
class Landscape:
    """M(w) [kg/m] and U(w) [J/m] with the equilibria [m] of U, NaN where there is none."""

    mass: CubicSpline
    potential: CubicSpline
    stable: float
    unstable: float

    @staticmethod
    def of(run: Run) -> "Landscape":
        """From the samples in a run's record."""
        data = run.data
        heave = data["curve_heave"].values
        mass, potential = (
            CubicSpline(heave, data[f"curve_{name}"].values) for name in ("inertia", "potential")
        )
        ends = (float(data[f"{name}_equilibrium"]) for name in ("stable", "unstable"))
        return Landscape(mass, potential, *ends)

    @property
    def equilibria(self) -> dict[str, float]:
        """Those that there are [m], by name."""
        both = {"stable": self.stable, "unstable": self.unstable}
        return {name: w for name, w in both.items() if np.isfinite(w)}

    def turns(self, energy: float) -> Vector:
        """Heave [m] at which U is `energy`, ascending."""
        return np.sort(self.potential.solve(energy, extrapolate=False))

    def level(self, energy: float, low: float, high: float) -> list[Vector]:
        """Curves of constant E between two heaves: halves (points, 2) with w' >= 0."""
        inner = [w for w in (*self.turns(energy), self.unstable) if low < w < high]
        halves = []
        for left, right in pairwise(np.unique([low, *inner, high])):
            # Denser towards both ends, where the curve may stand upright.
            w = (left + right) / 2 - (right - left) / 2 * np.cos(np.linspace(0, np.pi, _POINTS))
            lift = 2 * (energy - self.potential(w)) / self.mass(w)
            if lift[_POINTS // 2] > 0:
                halves.append(np.column_stack([w, np.sqrt(np.maximum(lift, 0))]))
        return halves

    @property
    def barrier(self) -> float:
        """E of the separatrix [J/m]; NaN where there is none."""
        return float(self.potential(self.unstable))

    def window(self, heave: Vector) -> tuple[float, float]:
        """Range of heave [m] with the motion, and the well that it is in if that lies near."""
        size = float(np.ptp(heave)) or 1.0
        near = float(heave.min()) - _AROUND * size, float(heave.max()) + _AROUND * size
        places = [*heave, *self.equilibria.values()]
        if np.isfinite(self.unstable):
            places += [w for w in self.turns(self.barrier) if w > self.stable][:1]
        seen = [float(w) for w in places if near[0] <= w <= near[1]]
        low, high = min(seen), max(seen)
        margin = _MARGIN * ((high - low) or size)
        return (
            max(low - margin, float(self.potential.x[0])),
            min(high + margin, float(self.potential.x[-1])),
        )

    def fastest(self, velocity: Vector) -> float:
        """Greatest velocity to show [m/s]: the motion's, or the separatrix's if that is near."""
        own = float(np.abs(velocity).max())
        drop = 2 * (self.barrier - float(self.potential(self.stable)))
        loop = float(np.sqrt(drop / self.mass(self.stable))) if np.isfinite(drop) else 0.0
        near = loop <= (1 + _AROUND) * own
        return (1 + _MARGIN) * (max(own, loop if near else 0.0) or loop or 1.0)


def energy(run: Run) -> Vector:
    """E of the steps [J/m], (time,): constant where the scheme keeps it."""
    data = run.data
    return np.asarray(data["initial_energy"].values + data["energy_residual"].values)


def kinetic(run: Run) -> Vector:
    """M w'^2/2 of the steps [J/m], (time,), with the water's inertia."""
    data = run.data
    inertia = data["ship_mass"].values + data["fluid_inertia"].values
    return np.asarray(inertia * data["heave_velocity"].values ** 2 / 2)
