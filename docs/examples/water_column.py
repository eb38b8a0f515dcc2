"""Somebody else's flow solver: the water of a U-tube, a program of its own that knows no squat.

It reads one JSON object a line (`position`, `velocity`, `acceleration` of the piston, SI) and
answers `{"force": ...}` [N]. Any language and any solver could stand in its place.
"""

import json
import sys

DENSITY, GRAVITY = 1000.0, 9.81  # kg/m3, m/s2
AREA, LENGTH = 0.1, 1.0  # of the tube, m2, of the water column, m


def force(position: float, acceleration: float) -> float:
    """Pressure force on the piston less its weight at rest: inertia and difference of levels."""
    return -DENSITY * AREA * (LENGTH * acceleration + 2 * GRAVITY * position)


if __name__ == "__main__":
    for line in sys.stdin:
        trial = json.loads(line)
        answer = {"force": force(trial["position"], trial["acceleration"])}
        print(json.dumps(answer), flush=True)
