"""Where points that are fixed to the ship are at the times of a record."""

import numpy as np

from squat.quantities import Vector
from squat.replay.runs import Run


def moved(run: Run, points: Vector, time: Vector) -> Vector:
    """Points (n, 2) of the hull at rest as they lie at `time` (m,) [s], shape (m, n, 2).

    Turned by the pitch about the record's centre, positive bow down, then moved by surge and heave.
    """
    surge, heave, pitch = (_at(run, mode, time) for mode in ("surge", "heave", "pitch"))
    center = run.data["center"].values
    x, z = (points - center).T
    sin, cos = np.sin(pitch)[:, None], np.cos(pitch)[:, None]
    turned = np.stack([cos * x - sin * z, sin * x + cos * z], axis=-1)
    return np.asarray(center + np.stack([surge, heave], axis=-1)[:, None] + turned)


def _at(run: Run, mode: str, time: Vector) -> Vector:
    """A coordinate at `time`; zero in a mode that the record does not hold."""
    if not run.has(mode):
        return np.zeros_like(time)
    return np.asarray(np.interp(time, run.steps.time, run.data[mode].values))
