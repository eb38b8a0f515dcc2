"""The channel's longitudinal section."""

from pydantic.dataclasses import dataclass

from squat.channel.hull import Hull
from squat.errors import InputError
from squat.quantities import STRICT, Length


@dataclass(frozen=True, kw_only=True, config=STRICT)
class Channel:
    """Channel of constant depth around a ship (Fig. 3, section 3.6).

    Parameters
    ----------
    depth
        H [m], from the bottom to the water line.
    upstream
        Distance from the bow to the boundary In [m].
    downstream
        Distance from the stern to the boundary Out [m].
    """

    depth: Length
    upstream: Length
    downstream: Length


def check_afloat(hull: Hull, channel: Channel) -> None:
    """Raise InputError unless `hull` floats clear of the bottom of `channel`."""
    if hull.draft >= channel.depth:
        raise InputError(
            f"hull.draft={hull.draft:g}: must be less than channel.depth={channel.depth:g}"
        )
