"""The positions that a reduced model answers for: a box in log(clearance) and pitch."""

from dataclasses import dataclass, replace
from typing import Annotated

import numpy as np
from pydantic import Field
from pydantic.dataclasses import dataclass as checked

from squat.errors import InputError
from squat.mesh import PositionError, Submesh
from squat.mesh.limits import PITCH
from squat.mesh.submesh import clearance
from squat.quantities import STRICT, Count, Fraction, Vector


@checked(frozen=True, kw_only=True, config=STRICT)
class BoxSize:
    """How far a reduced model reaches, and how densely it is trained.

    Parameters
    ----------
    clearance
        Least clearance over that at rest.
    pitch
        Largest pitch [rad] either way; 0: heave alone.
    points
        Training positions along log(clearance).
    pitch_points
        Training positions along pitch.
    """

    clearance: Fraction
    pitch: Annotated[float, Field(strict=True, ge=0, le=PITCH)]
    points: Count
    pitch_points: Count

    @property
    def modes(self) -> tuple[str, ...]:
        """Rigid modes that the box spans."""
        return ("heave", "pitch") if self.pitch else ("heave",)


@dataclass(frozen=True, eq=False)
class Box:
    """Admissible positions of one submesh within a `BoxSize`."""

    submesh: Submesh
    size: BoxSize

    def __post_init__(self) -> None:
        if self.submesh.modes != self.size.modes:
            raise InputError(
                f"reduced.box.pitch={self.size.pitch:g}: spans {', '.join(self.size.modes)}, the "
                f"motion has {', '.join(self.submesh.modes)}; give reduced.box.pitch=0 for heave"
            )

    @property
    def bounds(self) -> tuple[float, float]:
        """Least and greatest clearance [m] of the untrimmed hull."""
        limits = self.submesh.limits
        return self.size.clearance * limits.clearance, limits.clearance + min(
            limits.draft / 2, 0.9 * limits.wall
        )

    @property
    def middle(self) -> Vector:
        """The position with the geometric mean of both clearances, untrimmed."""
        return self.position(float(np.sqrt(np.prod(self.bounds))), 0.0)

    def position(self, gap: float, pitch: float) -> Vector:
        """q whose least clearance is `gap` [m] at `pitch` [rad], shape (modes,)."""
        moved = self.submesh.motion.positions(np.array([0.0, 0.0, pitch]))
        heave = gap - clearance(moved[self.submesh.keel], self.submesh.bed)
        return np.array([heave, pitch][: len(self.size.modes)])

    def clearance(self, position: Vector) -> float:
        """Least clearance [m] at `position`."""
        moved = self.submesh.motion.positions(self.submesh.full(position))
        return clearance(moved[self.submesh.keel], self.submesh.bed)

    def grid(self) -> list[Vector]:
        """Training positions: a grid in log(clearance) and pitch, inadmissible ones left out."""
        gaps = np.geomspace(*self.bounds, self.size.points)
        gaps[0], gaps[-1] = self.bounds
        pitches = np.linspace(-self.size.pitch, self.size.pitch, self.size.pitch_points)
        angles = pitches if self.size.pitch else np.zeros(1)
        return [q for gap in gaps for a in angles if self._admits(q := self.position(gap, a))]

    def random(self, count: int, seed: int) -> list[Vector]:
        """`count` positions, uniform in log(clearance) and pitch."""
        draw = np.random.default_rng(seed)
        found: list[Vector] = []
        while len(found) < count:
            gap = float(np.exp(draw.uniform(*np.log(self.bounds))))
            q = self.position(gap, float(draw.uniform(-1, 1)) * self.size.pitch)
            found += [q] if self._admits(q) else []
        return found

    def limited(self) -> Submesh:
        """The submesh, refusing what lies below the box."""
        limits = replace(self.submesh.limits, fraction=self.size.clearance)
        return replace(self.submesh, limits=limits)

    def _admits(self, q: Vector) -> bool:
        try:
            self.limited().check(q)
        except PositionError:
            return False
        return True
