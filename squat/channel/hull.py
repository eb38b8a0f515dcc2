"""The hull's longitudinal section."""

from pydantic.dataclasses import dataclass

from squat.quantities import STRICT, Length


@dataclass(frozen=True, kw_only=True, config=STRICT)
class Hull:
    """Rectangular section of a ship floating at rest (Fig. 8, Table 6).

    Parameters
    ----------
    length
        L [m].
    draft
        T [m], the depth of the keel below the water line.
    """

    length: Length
    draft: Length
