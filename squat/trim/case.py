"""What the task `trim` is asked."""

from pydantic.dataclasses import dataclass

from squat.channel import AnyHull, Channel
from squat.mesh import MeshSize
from squat.quantities import STRICT, Angle, Area, Count, Fraction, Position, Positive
from squat.reduced import Training
from squat.water import Water


@dataclass(frozen=True, kw_only=True, config=STRICT)
class Released:
    """How the ship is set free, at rest: heave [m] and pitch [rad, positive bow down]."""

    heave: Position
    pitch: Angle


@dataclass(frozen=True, kw_only=True, config=STRICT)
class TrimCase:
    """A ship whose heave and pitch are followed over the current, up to where it is lost.

    Parameters
    ----------
    displacement
        Submerged area [m2] that the hull's length is stretched to; None: as it is.
    reduced
        Reduced model of the water that all is computed on.
    start
        Of the ship whose limits are sought.
    periods, steps_per_period
        Length and step of the runs of the bisection, in periods of small heave at rest.
    tolerance
        Of the bisection [m/s].
    arc, points
        Step of the continuation [m] and most points of the branch.
    """

    hull: AnyHull
    channel: Channel
    water: Water
    mesh: MeshSize
    reduced: Training
    displacement: Area | None
    start: Released
    grounding: Fraction
    periods: Positive
    steps_per_period: Count
    tolerance: Positive
    arc: Positive
    points: Count
