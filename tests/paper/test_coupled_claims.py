"""The numbered points of section 3.6, on a coarse mesh."""

import numpy as np
import pytest

from squat.analysis.transient_claims import period, turning_points
from squat.analysis.verdicts import claim_rows


@pytest.fixture(scope="module")
def verdicts(sources):
    return {row["claim"]: row for row in claim_rows(sources)}


def test_turning_points_of_a_cosine():
    t = np.linspace(0, 20, 400)
    assert turning_points(t, np.cos(t)) == pytest.approx(np.pi * np.arange(1, 7), abs=1e-3)


def test_small_motion_has_the_period_of_the_lids_inertia(sources):
    """Not of Eq. (5) with m_add of (23): 25 s against 13.7 s, damped a little on top."""
    run = sources.run("printed", 1.0)
    inertia = float(run["ship_mass"] + run["fluid_inertia"].mean())
    theory = 2 * np.pi * np.sqrt(inertia / (1000 * 9.81 * 40))
    assert period(run) == pytest.approx(theory, rel=0.05)
    assert period(run) > 1.7 * 2 * np.pi / float(run["omega"])


@pytest.mark.parametrize(
    ("start", "verdict"),
    [
        ("With no added mass correction", "match"),
        ("In the stable cases the ship oscillates", "match"),
        ("The pressure under the hull", "match"),
        ("In the unstable case the number", "differs"),
        ("The observed period", "match"),
        ("Irrespective of the stability", "differs"),
        ("Stable at 1, 2 and 2.25", "match"),
        ("The precision order", "match"),
        ("The ship has stable positions", "differs"),
        ("The added mass of Eqs. (22) to (26)", "paper inconsistent"),
        ("What is lost by the structure", "differs"),
        ("Without loss of generality", "differs"),
        ("It is possible to add new degrees", "match"),
        ("The coupling depends on the added mass matrix", "match"),
    ],
)
def test_numbered_points_have_their_verdicts(verdicts, start, verdict):
    row = next(row for claim, row in verdicts.items() if claim.startswith(start))
    assert row["verdict"] == verdict, row
