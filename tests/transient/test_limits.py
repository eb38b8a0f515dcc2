"""Limits that follow from the energies alone, against coupled runs on the same mesh."""

import numpy as np
import pytest

from squat import transient
from squat.config import compose, validate
from squat.stability.branches import equilibria
from squat.stability.dynamic import dynamic_squat_speed
from squat.stability.fold import squat_speed
from squat.stability.orbits import orbit

SHARE = 0.002
"""Distance from the limit on either side."""


def run(mesh, model, current, heave):
    """A run that keeps its energy, until it turns or comes within a tenth of the bottom."""
    given = validate(
        compose(
            "transient",
            f"mesh={mesh}",
            f"model={model}",
            "accuracy.near=0.4",
            "force=variational",
            "coupling=energy_momentum",
            "grounding=0.1",
            "time.until=turn",
            "time.periods=20.0",
            f"current={current}",
            f"initial_heave={heave}",
        )
    )
    return transient.run(given.case).dataset


@pytest.fixture(scope="module", params=["coarse", "paper"])
def mesh(request):
    return request.param


@pytest.fixture(scope="module")
def ship(mesh):
    case = validate(compose("stability", f"mesh={mesh}")).case
    return case.ship.on(case.mesh)


@pytest.fixture(scope="module")
def fold(ship):
    return squat_speed(ship.at_current)


def model_of(mesh):
    return "full" if mesh == "coarse" else "curves"


@pytest.mark.parametrize(("side", "status"), [(-1, "turned"), (1, "grounded")])
def test_dynamic_squat_speed_separates_runs_that_turn_from_runs_that_ground(
    mesh, ship, fold, side, status
):
    limit = dynamic_squat_speed(ship.at_current, fold, -0.1, 0.0)
    current = (1 + side * SHARE) * limit
    data = run(mesh, model_of(mesh), current, -0.1)
    assert data.attrs["status"] == status
    if status == "turned":
        found = orbit(ship.at_current(current), -0.1, 0.0)
        # The last step overshoots the turn by at most one step, in which the ship hardly moves.
        assert float(data["heave"].min()) == pytest.approx(found.low, abs=1e-4)
        step = float(data["time_step"])
        assert float(data["time"][-1]) == pytest.approx(found.period / 2, abs=1.5 * step)


@pytest.mark.parametrize(("side", "status"), [(-1, "turned"), (1, "grounded")])
def test_beyond_the_2d_squat_speed_a_ship_grounds_even_from_where_the_equilibria_merge(
    mesh, ship, fold, side, status
):
    current = (1 + side * SHARE) * fold.speed
    data = run(mesh, "curves", current, fold.sinkage)
    assert data.attrs["status"] == status
    assert len(equilibria(ship.at_current(current))) == (2 if side < 0 else 0)
    rises = np.diff(data["heave"].values[:20]) > 0
    assert rises.all() if side < 0 else not rises.any()


def test_the_1d_squat_speed_is_no_limit_of_the_coupled_run(mesh, ship, fold):
    """Well below it, but above the 2D limit, the ship is lost from rest."""
    data = run(mesh, "curves", fold.speed * 1.05, 0.0)
    assert data.attrs["status"] == "grounded"
