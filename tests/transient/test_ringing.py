"""Why the printed scheme rings at the start: the recurrence of its accelerations for dt -> 0."""

import numpy as np
import pytest

from squat.transient.run import run

SHORT = "current=2", "time.steps_per_period=3500", "time.periods=0.004"


def test_centred_accelerations_follow_the_recurrence_of_the_theory(ship):
    """m a_n + c/4 (a_n + 2 a_{n-1} + a_{n-2}) = F, and the water is still before the start."""
    data = run(ship(*SHORT, "coupling.criterion.tolerance=1e-12")).dataset
    m, c = float(data["ship_mass"]), float(data["fluid_inertia"][0])
    a = np.r_[0.0, data["heave_acceleration"].values]
    force = m * a[2:] + c / 4 * (a[2:] + 2 * a[1:-1] + a[:-2])
    assert force == pytest.approx(force[0], rel=2e-3)
    roots = np.roots([m + c / 4, c / 2, c / 4])
    ratio = np.sqrt(c / (4 * m))
    assert np.abs(roots) == pytest.approx(ratio / np.sqrt(1 + ratio**2))
    assert np.sum(np.diff(np.sign(np.diff(a[1:]))) != 0) > 10


def test_a_run_released_with_the_balanced_acceleration_is_smooth(ship):
    data = run(ship(*SHORT, "coupling=consistent")).dataset
    a = data["heave_acceleration"].values
    assert np.abs(np.diff(a)).max() < 0.02 * np.abs(a).max()
