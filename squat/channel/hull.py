"""What every hull section is: length, draft, and a wetted chain from bow to stern."""

import math
from abc import ABC, abstractmethod
from typing import Annotated, Literal

import numpy as np
from pydantic import Field
from pydantic.dataclasses import dataclass

from squat.channel.outline import Outline
from squat.quantities import STRICT, Length, Point, Vector

PitchCenter = Literal["waterline", "centroid"]
Segments = Annotated[int, Field(strict=True, ge=3, le=400)]


@dataclass(frozen=True, kw_only=True, config=STRICT)
class Hull(ABC):
    """Longitudinal section of a ship floating at rest (Fig. 8, Table 6).

    Hull coordinates: x [m] from the bow at the water line towards the stern, z [m] from the
    still water line upwards. Above the water every hull goes on with vertical walls.

    Parameters
    ----------
    length
        L [m], along the still water line.
    draft
        T [m], the depth of the keel below the water line.
    pitch_center
        Point that pitch turns about: `waterline`, mid-length on the still water line, or
        `centroid`, that of the submerged section. It is what added-mass matrices refer to; runs
        turn about the centre of gravity.
    gravity_center
        Centre of gravity (x, z) [m]. None: at half the draft, in line with the centre of buoyancy.
    gyradius
        Radius of gyration of the ship's mass about it [m]. None: that of a homogeneous rectangle
        of `length` and height `draft`.
    """

    length: Length
    draft: Length
    pitch_center: PitchCenter = "waterline"
    gravity_center: Point | None = None
    gyradius: Length | None = None

    @abstractmethod
    def section(self) -> Vector:
        """Wetted chain (n, 2) from the bow's water line point to the stern's."""

    def remark(self) -> str:
        """What a user should be told of the section, in a line; empty: nothing."""
        return ""

    @property
    def outline(self) -> Outline:
        """The section as a checked polygon; raises InputError where it is none."""
        return Outline.of(self.section(), self.draft, self.pitch_center)

    @property
    def center_of_gravity(self) -> Vector:
        """Centre of gravity, shape (2,) [m]."""
        if self.gravity_center is not None:
            return np.array(self.gravity_center)
        return np.array([self.outline.centroid[0], -self.draft / 2])

    @property
    def radius_of_gyration(self) -> float:
        """Radius of gyration about the centre of gravity [m]."""
        if self.gyradius is not None:
            return self.gyradius
        return math.hypot(self.length, self.draft) / math.sqrt(12)


def arc(center: tuple[float, float], radius: float, start: float, end: float, n: int) -> Vector:
    """Points (n + 1, 2) of a circular arc between two angles [rad], both ends included."""
    angle = np.linspace(start, end, n + 1)
    return np.asarray(center) + radius * np.stack([np.cos(angle), np.sin(angle)], axis=1)


def half_turn(n: int) -> Vector:
    """Angles (n + 1,) from the bow (pi) over the keel to the stern (2 pi)."""
    return np.linspace(math.pi, 2 * math.pi, n + 1)
