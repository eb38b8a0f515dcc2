"""What the task `trim` is asked."""

from dataclasses import replace
from typing import Annotated, ClassVar

from pydantic import Field
from pydantic.dataclasses import dataclass

from squat.channel import AnyHull, Channel
from squat.fluid.accuracy import LEVELS, extrapolate
from squat.mesh import MeshSize
from squat.quantities import STRICT, Angle, Area, Count, Fraction, Position, Positive, Vector
from squat.reduced import Training
from squat.water import Water


@dataclass(frozen=True, kw_only=True, config=STRICT)
class Released:
    """How the ship is set free, at rest: heave [m] and pitch [rad, positive bow down]."""

    heave: Position
    pitch: Angle


@dataclass(frozen=True, kw_only=True, config=STRICT)
class Companions:
    """Coarser meshes, and what their values say about the error of those on the case's mesh.

    Parameters
    ----------
    refinement
        Ratio of the element sizes of one mesh and the next.
    safety
        Factor on the estimated error, 1.25 with three meshes (Roache).
    """

    refinement: Annotated[float, Field(strict=True, gt=1, le=4)]
    safety: Positive

    def sizes(self, mesh: MeshSize) -> list[MeshSize]:
        """Sizes of the coarser meshes, the coarsest first."""
        return [_coarser(mesh, self.refinement**power) for power in range(LEVELS - 1, 0, -1)]

    def error(self, values: Vector) -> Vector:
        """Errors of the last row of `values` (LEVELS, n), the coarsest mesh's first; NaN: none."""
        return extrapolate(list(values), self.refinement, self.safety).error


def _coarser(mesh: MeshSize, factor: float) -> MeshSize:
    near, far = factor * mesh.near, factor * mesh.far
    return replace(mesh, near=near, far=far, corner_radius=max(mesh.corner_radius, 1.1 * near))


@dataclass(frozen=True, kw_only=True, config=STRICT)
class TrimCase:
    """A ship whose heave and pitch are followed over the current, up to where it is lost.

    Parameters
    ----------
    displacement
        Submerged area [m2] that the hull's length is stretched to; None: as it is.
    companions
        Coarser meshes, for the errors.
    reduced
        Reduced model of the water that all is computed on.
    start
        Of the ship whose limits are sought.
    periods, steps_per_period
        Length and step of the runs of the bisection, in periods of small heave at rest.
    tolerance
        Of the bisection [m/s].
    arc, points
        Step of the continuation over the clearance at rest, and most points of the branch.
    """

    free_surface: ClassVar = "rigid_lid"

    hull: AnyHull
    channel: Channel
    water: Water
    mesh: MeshSize
    companions: Companions
    reduced: Training
    displacement: Area | None
    start: Released
    grounding: Fraction
    periods: Positive
    steps_per_period: Count
    tolerance: Positive
    arc: Positive
    points: Count

    @property
    def step(self) -> float:
        """Step of the continuation [m]."""
        return self.arc * (self.channel.depth - self.hull.draft)
