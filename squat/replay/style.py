"""Colours of the recordings: Okabe and Ito's, in order of contrast on the viewer's ground."""

import math

import matplotlib as mpl
import numpy as np
from matplotlib.colors import to_rgba_array
from matplotlib.ticker import MaxNLocator
from numpy.typing import NDArray

from squat.quantities import Vector

SKY, ORANGE, GREEN, PURPLE, YELLOW, RED, BLUE = (
    "#56B4E9",
    "#E69F00",
    "#009E73",
    "#CC79A7",
    "#F0E442",
    "#D55E00",
    "#0072B2",
)
RUNS = (SKY, ORANGE, GREEN, PURPLE, YELLOW, RED, BLUE)
"""Colours of compared runs, in turn."""
GREY, PALE = "#999999", "#DDDDDD"
COLORMAP = "viridis"
"""Perceptually uniform, readable without colour vision."""


def rgba(*names: str) -> NDArray[np.uint8]:
    """Colours (n, 4), as rerun takes them, of names or of #RRGGBB[AA]."""
    return np.asarray(np.round(to_rgba_array(names) * 255), np.uint8)


def run_color(number: int) -> str:
    """Colour of the run of that number, from 0."""
    return RUNS[number % len(RUNS)]


def colors(values: Vector, limits: tuple[float, float]) -> NDArray[np.uint8]:
    """RGBA (..., 4) of `values`, those beyond `limits` in the colours of its ends."""
    low, high = limits
    share = np.clip((np.nan_to_num(values) - low) / (high - low), 0, 1)
    return np.asarray(mpl.colormaps[COLORMAP](share, bytes=True))


def ticks(low: float, high: float, count: int = 6) -> Vector:
    """Round numbers within [low, high]."""
    found = np.asarray(MaxNLocator(count, steps=[1, 2, 2.5, 5, 10]).tick_values(low, high))
    return np.asarray(found[(found >= low) & (found <= high)])


_MOST, _LEAST = 14, 3
_NEAR = 0.21  # of the range: a line so near to its end is worth the room


def ticked(low: float, high: float) -> tuple[float, float]:
    """The range [low, high], widened to lines near by where the viewer would number too few.

    Its time plots have lines at multiples of powers of ten, and room for the numbers of some
    fourteen: of -9 to 9 it would number 0 alone.
    """
    if not high > low:
        return low, high
    step = 10.0 ** math.ceil(math.log10((high - low) / _MOST))
    if _lines(low, high, step) >= _LEAST:
        return low, high
    below, above = math.floor(low / step) * step, math.ceil(high / step) * step
    near = max(_NEAR * (high - low), min(low - below, above - high))
    margin = 0.04 * step
    low = below - margin if low - below <= near else low
    high = above + margin if above - high <= near else high
    return low, high


def _lines(low: float, high: float, step: float) -> int:
    return math.floor(high / step) - math.ceil(low / step) + 1
