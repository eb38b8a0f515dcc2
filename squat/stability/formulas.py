"""The usual formulas for squat, each within the range that its author gave it.

They are for ships in three dimensions; V in m/s, lengths in m. Sources: docs/theory/stability.md.
"""

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import NamedTuple

from squat.channel import Channel, Rectangle
from squat.stability.equilibria import OneDimensionalModel
from squat.water import Water

KNOT = 1852 / 3600
_ROUNDING = 1e-9
"""Of a value: what a draft of 6 m that is read off a curved hull may miss it by, and more."""


@dataclass(frozen=True)
class Particulars:
    """What the formulas ask about ship and waterway.

    Parameters
    ----------
    block
        C_B: here the area coefficient of the longitudinal section.
    beam, width
        B and W [m]; both None: the ship fills the channel's width; width None: open water.
    """

    length: float
    draft: float
    block: float
    depth: float
    speed: float
    gravity: float
    beam: float | None
    width: float | None

    @property
    def froude(self) -> float:
        """Depth Froude number V/sqrt(g H)."""
        return self.speed / math.sqrt(self.gravity * self.depth)

    @property
    def blockage(self) -> float:
        """S = B T/(W H): T/H where the ship fills the width, 0 in open water."""
        if self.beam is None:
            return self.draft / self.depth
        return 0.0 if self.width is None else self.beam * self.draft / (self.width * self.depth)


class Answer(NamedTuple):
    """Squat [m], limit speed [m/s], and a remark; NaN where the formula says nothing."""

    squat: float
    limit: float
    note: str


class Formula(NamedTuple):
    """A formula by name, with its source."""

    name: str
    source: str
    answer: Callable[[Particulars], Answer]


def _refused(*conditions: tuple[bool, str]) -> str:
    """The conditions that do not hold, in words."""
    return "; ".join(text for holds, text in conditions if not holds)


def _within(name: str, value: float, low: float, high: float) -> tuple[bool, str]:
    """Whether a value is in a range whose ends belong to it, and the words if it is not."""
    holds = low - _ROUNDING * value <= value <= high + _ROUNDING * value
    told = next((text for text in _digits(value) if not low <= float(text) <= high), f"{value}")
    return holds, f"{name} = {told} is outside {low:g} to {high:g}"


def _digits(value: float) -> Iterator[str]:
    """The value in words, three digits at first."""
    return (f"{value:.{digits}g}" for digits in range(3, 17))


def _unless(refused: str, squat: Callable[[], float]) -> Answer:
    if refused:
        return Answer(math.nan, math.nan, refused)
    return Answer(squat(), math.nan, "")


def schijf(ship: Particulars) -> Answer:
    """Continuity and Bernoulli in one dimension, for any blockage S: Eq. (27) with T = S H."""
    if ship.blockage == 0:
        return Answer(math.nan, math.nan, "needs width= of the channel")
    hull = Rectangle(length=ship.length, draft=ship.blockage * ship.depth)
    channel = Channel(depth=ship.depth, upstream=ship.length, downstream=ship.length)
    model = OneDimensionalModel(hull, channel, Water(density=1.0, gravity=ship.gravity))
    limit = model.squat_speed().speed
    note = "" if ship.speed < limit else "beyond its limit speed"
    return Answer(-float(model.roots(ship.speed).stable), limit, note)


def barrass(ship: Particulars) -> Answer:
    """C_B (S/(1 - S))^(2/3) V_knots^2.08 / 30."""
    S = ship.blockage
    if S == 0:
        return Answer(math.nan, math.nan, "needs width= of the channel")
    refused = _refused(
        _within("S", S, 0.1, 0.266),
        _within("C_B of the section", ship.block, 0.5, 0.9),
        _within("H/T", ship.depth / ship.draft, 1.1, 1.5),
    )
    return _unless(
        refused, lambda: ship.block * (S / (1 - S)) ** (2 / 3) * (ship.speed / KNOT) ** 2.08 / 30
    )


def _slender(ship: Particulars) -> float:
    """2.4 (volume/L^2) Fr^2/sqrt(1 - Fr^2) [m]."""
    assert ship.beam is not None
    volume = ship.block * ship.length * ship.beam * ship.draft
    return 2.4 * volume / ship.length**2 * ship.froude**2 / math.sqrt(1 - ship.froude**2)


_BEAM = "needs beam= of the ship"


def icorels(ship: Particulars) -> Answer:
    """Tuck's slender-body sinkage as ICORELS gives it, for open water."""
    refused = _refused(
        (ship.beam is not None, _BEAM),
        (ship.beam is None or ship.width is None, "for open water; leave width= out"),
        _within("Fr_h", ship.froude, 0, 0.7),
    )
    return _unless(refused, lambda: _slender(ship))


def huuska(ship: Particulars) -> Answer:
    """ICORELS times K_s = 7.45 S + 0.76 for a canal of blockage S > 0.03."""
    if ship.beam is None:
        return Answer(math.nan, math.nan, _BEAM)
    S = ship.blockage
    refused = _refused(
        _within("C_B of the section", ship.block, 0.6, 0.8),
        _within("B/T", ship.beam / ship.draft, 2.19, 3.5),
        _within("L/B", ship.length / ship.beam, 5.5, 8.5),
        _within("H/T", ship.depth / ship.draft, 1.1, 2.0),
        _within("Fr_h", ship.froude, 0, 0.7),
    )
    return _unless(refused, lambda: (7.45 * S + 0.76 if S > 0.03 else 1.0) * _slender(ship))


def eryuzlu(ship: Particulars) -> Answer:
    """0.298 (H^2/T) (V/sqrt(g T))^2.289 (H/T)^-2.972 K_b, K_b = 3.1/sqrt(W/B) for W < 9.61 B."""
    H, T = ship.depth, ship.draft
    if ship.beam is None:
        return Answer(math.nan, math.nan, _BEAM)
    wide = math.inf if ship.width is None else ship.width / ship.beam
    refused = _refused(
        _within("C_B of the section", ship.block, 0.8, 1.0),
        _within("B/T", ship.beam / T, 2.4, 2.9),
        _within("L/B", ship.length / ship.beam, 6.7, 6.8),
        _within("H/T", H / T, 1.1, 2.5),
    )
    narrowing = 3.1 / math.sqrt(wide) if wide < 9.61 else 1.0
    speed = ship.speed / math.sqrt(ship.gravity * T)
    return _unless(refused, lambda: 0.298 * H**2 / T * speed**2.289 * (H / T) ** -2.972 * narrowing)


FORMULAS = (
    Formula("Schijf", "Schijf, PIANC Congress XVII, Lisbon, 1949", schijf),
    Formula("Barrass", "Barrass, Int. Shipbuilding Progress 26, 1979", barrass),
    Formula("Tuck/ICORELS", "Tuck, J. Fluid Mech. 26, 1966; ICORELS, PIANC, 1980", icorels),
    Formula("Huuska/Guliev", "Huuska, Helsinki Univ. Tech. Rep. 9, 1976", huuska),
    Formula("Eryuzlu", "Eryuzlu, Cao, D'Agnolo, PIANC Congress 28, Seville, 1994", eryuzlu),
)
