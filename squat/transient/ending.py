"""What ends a run early: the bottom, too much trim, or a turning point."""

import math
from dataclasses import dataclass
from typing import Literal

import xarray as xr
from scipy.interpolate import CubicSpline

from squat.dynamics import Motion
from squat.mesh import Submesh
from squat.mesh.limits import PITCH
from squat.quantities import Vector
from squat.transient.case import TransientCase
from squat.transient.parts import Parts

_TRIM = 0.98
"""Share of the mesh's largest pitch beyond which a run ends."""
_LEARNT = 0.9
"""The same share of the reduced model's: a step short of it, so that the cause can be told."""
Exit = Literal["grounded", "overtrimmed"]
_REMEDY = "coupling=consistent_quasi_newton takes large added mass"


@dataclass
class Ending:
    """Watches the accepted steps of one run.

    Parameters
    ----------
    submesh
        The hull over the bottom.
    least
        Clearance [m] below which the ship counts as grounded.
    heave
        Place of heave in q.
    greatest_pitch
        Pitch [rad] beyond which the ship counts as overtrimmed.
    resolved
        Speed [m/s] below which the sign of a velocity says nothing: it moves the ship by less in
        a step than the tolerance to which the step is solved. None: turning points are no end.
    direction
        Sign of the first resolved velocity; 0 while the ship has not moved.
    """

    submesh: Submesh
    least: float
    heave: int
    greatest_pitch: float
    resolved: float | None
    direction: int = 0
    status: Exit | Literal["turned"] | None = None

    @staticmethod
    def of(case: TransientCase, parts: Parts) -> "Ending":
        """What ends `case`."""
        submesh = parts.fluid.mesh.submesh
        criterion = case.coupling.criterion
        scale = 1.0 if criterion.name == "absolute" else abs(case.initial_heave)
        turns = case.time.until == "turn"
        resolved = criterion.tolerance * scale / parts.dt if turns else None
        least = case.grounding * submesh.limits.clearance
        return Ending(submesh, least, case.place, _greatest_pitch(case), resolved)

    def see(self, position: Vector, velocity: Vector) -> None:
        """Take note of one more accepted step, q and q' (n,)."""
        speed = float(velocity[self.heave])
        if (left := self._exit(position)) is not None:
            self.status = left
        elif self.resolved is None:
            return
        elif self.direction == 0:
            self.direction = (speed > self.resolved) - (speed < -self.resolved)
        elif speed * self.direction < 0:
            self.status = "turned"

    def ahead(self, motion: Motion, dt: float) -> Exit | None:
        """What the ship meets within `dt` [s] if it keeps the acceleration of `motion`.

        A step that fails there has not failed for want of a better scheme: its end does not exist.
        """
        q, velocity, acceleration = motion
        return self._exit(q + dt * velocity + dt**2 / 2 * acceleration)

    def _exit(self, position: Vector) -> Exit | None:
        if self.submesh.clearance(position) < self.least:
            return "grounded"
        if abs(self.submesh.full(position)[2]) > self.greatest_pitch:
            return "overtrimmed"
        return None


def told(dataset: xr.Dataset, case: TransientCase) -> str:
    """How and where the run of `case` in `dataset` ended, for the log."""
    status, failed = str(dataset.attrs["status"]), dataset["failed_residual"].size > 0
    if status == "completed":
        return f"{status} at {_length(dataset)}"
    last, heave = dataset.sizes["time"] - 1, float(dataset["heave"][-1])
    kept = f"after step {last}, " if failed else ""
    where = f"{status} at step {last + failed} of {case.time.steps}"
    where += f"; {kept}w = {heave:.4g} m, {_length(dataset)}"
    scheme = status in ("diverged", "iteration limit") and case.coupling.name.startswith("printed")
    return f"{where}; {_REMEDY}" if scheme else where


def _length(dataset: xr.Dataset) -> str:
    """How long the run was, where it can be told in periods about its equilibrium too.

    The periods of `time.periods` are those of Eqs. (5) and (23), not of this oscillation.
    """
    seconds, period = float(dataset["time"][-1]), small_period(dataset)
    if not math.isfinite(period):
        return f"t = {seconds:.4g} s"
    return f"t = {seconds:.4g} s; small heave about its equilibrium has a period of {period:.4g} s"


def small_period(dataset: xr.Dataset) -> float:
    """Period [s] of small heave about the run's stable equilibrium; NaN where that is unknown."""
    stable = float(dataset.get("stable_equilibrium", math.nan))
    if math.isnan(stable):
        return math.nan
    heave = dataset["curve_heave"].values
    U, M = (
        CubicSpline(heave, dataset[f"curve_{name}"].values) for name in ("potential", "inertia")
    )
    stiffness = float(U(stable, 2))
    return 2 * math.pi * math.sqrt(float(M(stable)) / stiffness) if stiffness > 0 else math.nan


def _greatest_pitch(case: TransientCase) -> float:
    greatest = float(_TRIM * PITCH)
    if case.model == "reduced" and "pitch" in case.modes:
        return min(greatest, _LEARNT * float(case.reduced.box.pitch))
    return greatest
