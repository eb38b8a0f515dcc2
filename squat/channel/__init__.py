"""The hull and the channel that it moves in: frozen, checked geometry."""

from typing import Annotated

from pydantic import Field

from squat.channel.channel import Channel, check_afloat
from squat.channel.hull import Hull
from squat.channel.outline import Outline, moments
from squat.channel.points import Curve, Polygon
from squat.channel.resize import resized, stretched
from squat.channel.shapes import ChamferedBox, HalfEllipse, Lewis, Rectangle, RoundedBox, Vee

AnyHull = Annotated[
    Rectangle | HalfEllipse | Vee | ChamferedBox | RoundedBox | Lewis | Polygon | Curve,
    Field(discriminator="shape"),
]
"""Any hull of the configuration, told apart by its key `shape`."""

__all__ = [
    "AnyHull",
    "ChamferedBox",
    "Channel",
    "Curve",
    "HalfEllipse",
    "Hull",
    "Lewis",
    "Outline",
    "Polygon",
    "Rectangle",
    "RoundedBox",
    "Vee",
    "check_afloat",
    "moments",
    "resized",
    "stretched",
]
