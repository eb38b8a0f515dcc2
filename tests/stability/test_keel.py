"""The part of a hull that faces down."""

import numpy as np

from squat.stability.keel import breaks, underside


def test_the_underside_of_a_box_is_its_keel_and_of_a_slope_what_is_less_steep_than_45_degrees():
    box = np.array([(0, 5), (0, 0), (10, 0), (10, 5)], float)
    assert underside(*box.T).tolist() == [1, 2]
    raked = np.array([(0, 3), (2, 0), (10, 0), (15, 3), (15, 5)], float)
    assert underside(*raked.T).tolist() == [1, 2, 3]


def test_a_flare_over_a_bulb_breaks_the_line_of_the_underside():
    outline = np.array([[0, 0], [4, -2], [4.1, -6], [1, -6.1], [1, -8], [30, -8], [30, 0]], float)
    under = underside(*outline.T)
    assert under.tolist() == [0, 1, 4, 5]
    assert breaks(under).tolist() == [2]


def test_a_single_node_between_steep_sides_breaks_the_line_too():
    outline = np.array([[0, -2], [4, -3], [5, -5], [6, -8], [30, -8]], float)
    under = underside(*outline.T)
    assert under.tolist() == [0, 1, 3, 4]
    assert breaks(under).tolist() == [2]
