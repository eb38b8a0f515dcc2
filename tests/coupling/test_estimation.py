"""Iterates that an effective added mass is estimated from."""

import numpy as np

from squat.coupling.estimation import _apart


def test_a_mode_that_hardly_moves_is_moved_as_the_most_moved_one_and_no_other_is():
    changes = np.array([2.0, -0.5, 1e-3, np.nan])
    assert list(_apart(changes, np.zeros(4))) == [2.0, -0.5, 2.0, 2.0]
    assert list(_apart(np.zeros(2), np.array([-3.0, 1.0]))) == [3.0, 3.0]
    assert list(_apart(np.zeros(2), np.zeros(2))) == [1.0, 1.0]
