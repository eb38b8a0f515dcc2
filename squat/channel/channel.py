"""The channel's longitudinal section."""

from pydantic.dataclasses import dataclass

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
