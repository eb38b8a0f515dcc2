"""One look for all figures."""

from typing import Any

from matplotlib.axes import Axes
from matplotlib.figure import Figure

# Okabe and Ito's palette: distinct for colour-blind readers too.
BLUE, ORANGE, GREEN, RED, PURPLE, SKY = (
    "#0072B2",
    "#E69F00",
    "#009E73",
    "#D55E00",
    "#CC79A7",
    "#56B4E9",
)
PALETTE = (BLUE, RED, GREEN, ORANGE, PURPLE, SKY, "#000000")
_LONGEST = 8.0
"""Width over height of a channel that is drawn with equal scales, about."""
SETTINGS: Any = {
    "font.size": 10,
    "axes.grid": True,
    "grid.alpha": 0.3,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "legend.frameon": False,
    "svg.hashsalt": "squat",
    "savefig.dpi": 160,
}


def single(width: float = 6.4, height: float = 4.4) -> tuple[Figure, Axes]:
    """A figure of one panel; sizes in inches."""
    figure = Figure(figsize=(width, height), layout="constrained")
    return figure, figure.add_subplot()


def stretch(width: float, height: float, longest: float = _LONGEST) -> int:
    """How many times heights are stretched in a picture of a long, shallow channel; 1: not."""
    return max(1, round(width / height / longest))


def depth_axis(axes: Axes, times: int, name: str = "$z$") -> None:
    """Equal scales, but for heights `times` times stretched, which a note says."""
    axes.set_aspect(times)
    axes.set_ylabel(f"{name} [m]")
    if times > 1:
        axes.annotate(
            f"heights × {times}",
            (1, 1),
            (0, 3),
            xycoords="axes fraction",
            textcoords="offset points",
            ha="right",
            size=8,
        )
