"""Every ready-made hull, composed as the command line does, in the channel of section 3.6."""

from functools import cache

from pydantic import TypeAdapter

from squat.channel import AnyHull, Channel, Hull
from squat.config import compose
from squat.mesh import Submesh, submesh

NAMES = (
    "rectangle",
    "half_ellipse",
    "v",
    "chamfered_box",
    "rounded_box",
    "lewis",
    "polygon",
    "curve",
)
CHANNEL = Channel(depth=20.0, upstream=40.0, downstream=60.0)


@cache
def hull(name: str, *overrides: str) -> Hull:
    keys = [f"hull={name}", *overrides]
    config = compose("equilibria", *keys)["hull"]
    found: Hull = TypeAdapter(AnyHull).validate_python(config)
    return found


@cache
def zones(name: str) -> Submesh:
    return submesh(hull(name), CHANNEL)
