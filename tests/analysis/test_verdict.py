"""Verdicts judge by the printed digits."""

import math

import pytest

from squat.analysis.claims import CHECKS
from squat.analysis.verdict import difference, judge
from squat.published import claims


@pytest.mark.parametrize(
    ("printed", "here", "rounds_down", "verdict"),
    [
        ("5", 5.9, True, "match"),
        ("5", 5.9, False, "differs"),
        ("5", 4.999, True, "differs"),
        ("-0.75", -0.7549, False, "match"),
        ("-0.75", -0.7551, False, "differs"),
        ("2.9", 2.85, False, "match"),
        ("2.9", 2.8499, False, "differs"),
        ("-1.4", -1.44, False, "match"),
        ("1e-12", 1e-14, False, "differs"),
        ("inf", math.inf, True, "match"),
        ("", math.inf, True, "match"),
        ("", 3.0, True, "differs"),
        ("3", math.inf, True, "differs"),
    ],
)
def test_judged_after_rounding_to_the_printed_digits(printed, here, rounds_down, verdict):
    assert judge(printed, here, rounds_down=rounds_down) == verdict


def test_difference_of_two_infinities_is_none():
    assert difference("inf", math.inf) == 0
    assert difference("2.5", 2.0) == -0.5
    assert math.isnan(difference("", math.inf))


def test_every_printed_sentence_has_a_check_and_the_reverse():
    assert set(CHECKS) == set(claims().index)
