"""Numbers on isolines: upright, off the boundary, the other lines and each other; or none."""

from collections.abc import Sequence

import numpy as np
from matplotlib.axes import Axes

from squat.quantities import Vector

_SIZE = 7.0  # of the digits, pt
_STEP = 2.0  # between points of a line that distances are measured from, pt
_APART = 2  # every which of these points is tried for a number
_LETTER = 0.6  # width of a digit over its size
_GAP = "\N{SIX-PER-EM SPACE}"  # in the line before and behind a number
_ROOM = 0.6  # from a number's middle line to anything else, over its size
_HALF_HEIGHT = 0.5  # of a number with the white around it, over its size
_STEEPEST = -70.0  # degrees; lines that fall more steeply are read upwards, all from one side


def numbers(values: Sequence[float]) -> list[str]:
    """`values` with as many decimals each, one at least where one reads as another upside down.

    So 6.0 and 7.0 stand for 6 and 7, and 4 and 8 for themselves.
    """
    plain = [f"{value:g}" for value in values]
    decimals = max((len(text.partition(".")[2]) for text in plain), default=0)
    decimals = max(decimals, int(any(map(_turned, plain))))
    return [f"{value:.{decimals}f}".replace("-", "\N{MINUS SIGN}") for value in values]


def _turned(text: str) -> bool:
    digits = set(text) - {"-"}
    return digits <= set("0689") and bool(digits & set("69")) and not text.endswith("0")


def label(axes: Axes, lines: Sequence[tuple[float, Vector]], rim: Vector, scale: Vector) -> None:
    """Write each line's value on it where that crosses nothing, along it or else level.

    `lines` (value, (n, 2)) and the boundary's edges `rim` (k, 2, 2) in m; `scale` (2,) in pt/m.
    """
    drawn = [_dense(line * scale) for _, line in lines]
    window = np.array(axes.get_xlim()) * scale[0]
    edges = [_dense(edge * scale) for edge in rim]
    taken = [edge for edge in edges if window[0] < edge[-1, 0] < window[1]]
    for n, text in enumerate(numbers([value for value, _ in lines])):
        half = _LETTER * _SIZE * (len(text) + 1) / 2
        obstacles = np.vstack([*taken, *drawn[:n], *drawn[n + 1 :]])
        x = drawn[n][:, 0]
        inside = np.flatnonzero((x > window[0] + half) & (x < window[1] - half))[::_APART]
        for angles in (_slopes(drawn[n], half), np.zeros(len(x))):
            away = _clearance(drawn[n][inside], angles[inside], half, obstacles)
            if away.max(initial=0) > _ROOM * _SIZE:
                place, angle = (part[inside[away.argmax()]] for part in (drawn[n], angles))
                _write(axes, text, place / scale, float(angle))
                taken.append(_covered(place, float(angle), half))
                break


def _dense(line: Vector) -> Vector:
    """`line` (n, 2) with points at most `_STEP` apart."""
    along = np.r_[0, np.cumsum(np.linalg.norm(np.diff(line, axis=0), axis=1))]
    points = np.linspace(0, along[-1], 2 + int(along[-1] / _STEP))
    return np.column_stack([np.interp(points, along, part) for part in line.T])


def _slopes(line: Vector, half: float) -> Vector:
    """Angle of the chord over a number's length at each point of `line`, in degrees."""
    reach = max(1, round(half / _STEP))
    index = np.arange(len(line))
    ends = (line[np.clip(index + way * reach, 0, len(line) - 1)] for way in (1, -1))
    dx, dy = np.subtract(*ends).T
    return np.asarray((np.degrees(np.arctan2(dy, dx)) - _STEEPEST) % 180 + _STEEPEST)


def _covered(place: Vector, angle: float, half: float) -> Vector:
    """Points along the edges and the middle of a number at `place` (2,), turned by `angle`."""
    steps = np.linspace(-half, half, 2 + int(2 * half / _STEP))
    turned = np.radians(angle)
    way, across = np.array([[np.cos(turned), np.sin(turned)], [-np.sin(turned), np.cos(turned)]])
    lines = [
        place + steps[:, None] * way + offset * _HALF_HEIGHT * _SIZE * across
        for offset in (-1, 0, 1)
    ]
    return np.concatenate(lines)


def _clearance(places: Vector, angles: Vector, half: float, obstacles: Vector) -> Vector:
    """Distance of the middles of such numbers, (n, 2) and (n,), from the nearest obstacle: (n,)."""
    found = np.full(len(places), np.inf)
    for n, (place, turned) in enumerate(zip(places, np.radians(angles), strict=True)):
        way = np.array([np.cos(turned), np.sin(turned)])
        away = obstacles - place
        beyond = np.maximum(np.abs(away @ way) - half, 0)
        found[n] = np.hypot(beyond, away @ [-way[1], way[0]]).min()
    return found


def _write(axes: Axes, text: str, place: Vector, angle: float) -> None:
    axes.text(
        float(place[0]),
        float(place[1]),
        f"{_GAP}{text}{_GAP}",
        size=_SIZE,
        rotation=angle,
        rotation_mode="anchor",
        ha="center",
        va="center_baseline",
        bbox={"fc": "w", "lw": 0, "pad": 0.6},
    )
