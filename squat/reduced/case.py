"""What a reduced model is made for."""

from pydantic.dataclasses import dataclass

from squat.channel import AnyHull, Channel
from squat.fluid.model import FreeSurface
from squat.mesh import MeshSize
from squat.quantities import STRICT
from squat.reduced.greedy import Training
from squat.water import Water


@dataclass(frozen=True, kw_only=True, config=STRICT)
class MeshInput:
    """Files of earlier tasks; None: make what is lacking.

    Parameters
    ----------
    mesh
        Dataset of task=mesh for the same hull, channel and mesh.
    """

    mesh: str | None


@dataclass(frozen=True, kw_only=True, config=STRICT)
class ReducedCase:
    """A hull in a channel whose flow is wanted in microseconds.

    Parameters
    ----------
    reduced
        Positions that the model answers for, and how well.
    fields
        Keep the basis functions on the whole mesh, for snapshots and replays.
    """

    hull: AnyHull
    channel: Channel
    water: Water
    mesh: MeshSize
    free_surface: FreeSurface
    reduced: Training
    fields: bool
    inputs: MeshInput
