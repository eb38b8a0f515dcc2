"""How a run ended: what the ship did, and what the scheme did, are told apart."""

import re

import numpy as np
import pytest

from squat.dynamics import Motion
from squat.stability.orbits import linear_period
from squat.stability.portrait import highest_pair
from squat.stability.sampling import Ship
from squat.transient.ending import Ending, small_period, told
from squat.transient.parts import prepare
from squat.transient.run import run

TINY = "mesh.near=4", "mesh.far=6"


def test_a_step_that_would_end_below_the_bottom_is_grounding_not_divergence(ship):
    case = ship("current=3", "coupling=consistent", *TINY)
    data = run(case).dataset
    assert data["failed_residual"].size > 0
    assert float(data["clearance"][-1]) > case.grounding * float(
        prepare(case).fluid.mesh.submesh.limits.clearance
    )
    assert data.attrs["status"] == "grounded"
    step = data.sizes["time"]
    assert told(data, case).startswith(
        f"grounded at step {step} of {case.time.steps}; after step {step - 1}, w = -"
    )
    assert "coupling=" not in told(data, case)


def test_a_scheme_that_fails_in_the_first_step_has_diverged(ship):
    case = ship("current=3", "coupling=printed_standard", *TINY)
    data = run(case).dataset
    assert data.attrs["status"] == "diverged"
    assert told(data, case) == (
        f"diverged at step 1 of {case.time.steps}; after step 0, w = -0.1 m, t = 0 s; "
        "coupling=consistent_quasi_newton takes large added mass"
    )


def test_a_run_to_its_end_says_how_long_it_was_and_its_period(ship):
    case = ship("coupling=consistent", "time.periods=0.2", "current=2", *TINY)
    data = run(case).dataset
    found = re.fullmatch(
        r"completed at t = (\S+) s; small heave .* a period of (\S+) s", told(data, case)
    )
    seconds, said = map(float, found.groups())
    assert seconds == pytest.approx(float(data["time"][-1]), rel=1e-3)
    mode = Ship(case.hull, case.channel, case.water, "rigid_lid", 0.02).on(case.mesh).at_current(2)
    period = linear_period(mode, highest_pair(mode)[0])
    assert small_period(data) == pytest.approx(period, rel=1e-3)
    assert said == pytest.approx(period, rel=1e-3)


def test_a_run_of_several_modes_is_told_in_seconds_alone(ship):
    case = ship("modes=[heave,pitch]", "coupling=consistent", "time.periods=0.02", *TINY)
    data = run(case).dataset
    assert told(data, case) == f"completed at t = {float(data['time'][-1]):.4g} s"


@pytest.mark.parametrize(
    ("heave", "pitch", "found"),
    [
        ((-9.5, 0.0, 0.0), (0.0, 0.0, 0.0), None),
        ((-9.5, -0.2, 0.0), (0.0, 0.0, 0.0), None),
        ((-9.5, -0.4, 0.0), (0.0, 0.0, 0.0), "grounded"),
        ((-9.5, 0.0, -0.8), (0.0, 0.0, 0.0), "grounded"),
        ((-9.5, 0.4, 0.0), (0.0, 0.0, 0.0), None),
        ((0.0, 0.0, 0.0), (0.24, 0.02, 0.0), "overtrimmed"),
        ((0.0, 0.0, 0.0), (-0.24, -0.02, 0.0), "overtrimmed"),
        ((0.0, 0.0, 0.0), (0.24, -0.02, 0.0), None),
    ],
)
def test_the_way_ahead_is_the_accepted_motion_going_on_for_a_step(ship, heave, pitch, found):
    case = ship("modes=[heave,pitch]", "coupling=consistent", *TINY)
    ending = Ending.of(case, prepare(case))
    assert ending.ahead(Motion(*np.array([heave, pitch]).T), 1.0) == found
