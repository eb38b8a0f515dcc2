"""The correction by the fluid that the run couples to: few iterations, one history."""

from dataclasses import replace

import numpy as np
import pytest

from squat.coupling import (
    Aitken,
    Anderson,
    ConstantRelaxation,
    InterfaceQuasiNewton,
    Monolithic,
    NoAcceleration,
)
from squat.stability.equilibria import OneDimensionalModel
from squat.transient.parts import prepare
from squat.transient.run import run

ACCELERATORS = {
    "none": NoAcceleration(name="none"),
    "relaxation": ConstantRelaxation(name="relaxation", factor=0.1),
    "aitken": Aitken(name="aitken", initial=0.1),
    "anderson": Anderson(name="anderson", depth=5, mixing=0.1, condition=1e8),
    "iqn_ils": InterfaceQuasiNewton(name="iqn_ils", initial=0.1, reuse=2, filter=1e-3),
}


@pytest.mark.parametrize(("coupling", "most"), [("consistent", 5), ("consistent_quasi_newton", 3)])
@pytest.mark.parametrize("current", [1, 2, 2.35, 2.42])
def test_at_most_so_many_iterations_a_step_to_a_ten_billionth_of_a_metre(
    ship, coupling, most, current
):
    """2.42 m/s is 0.99 of the fastest current that this ship survives on the coarse mesh."""
    periods = 3 if current == 2.42 else 1.5
    case = ship(f"current={current}", f"coupling={coupling}", f"time.periods={periods}")
    assert case.coupling.criterion.tolerance == 1e-10
    data = run(case).dataset
    assert data.attrs["status"] == "completed"
    assert data["iterations"][1:].max() <= most
    if current == 2.42:
        unstable = OneDimensionalModel(case.hull, case.channel, case.water).roots(2.42).unstable
        assert float(data["heave"].min()) < 0.7 * float(unstable)


@pytest.mark.parametrize("current", [1, 2.35])
def test_factor_that_the_correction_leaves_is_the_predicted_one(ship, current):
    data = run(ship(f"current={current}", "coupling=consistent", "time.periods=1")).dataset
    apart = abs(data["contraction"] - data["predicted_contraction"])[1:]
    assert float(abs(data["predicted_contraction"]).max()) < 0.01
    assert float(apart.max()) < 1e-3


def test_correction_follows_the_ship(ship):
    """beta c(w), not its value at the start: it grows as the clearance shrinks."""
    case = ship("coupling=consistent")
    parts = prepare(case)
    motion, _ = parts.problem.balanced(np.zeros(1), np.zeros(1), parts.dt)
    found = []
    for w in (0.0, -3.5):
        scheme = parts.coupling.scheme(motion._replace(position=np.array([w])))
        c = parts.fluid.coefficients(np.array([w])).c
        assert scheme.added_mass == pytest.approx(0.75 * c, rel=1e-9)
        found.append(float(scheme.added_mass[0, 0]))
    assert found[1] > 1.2 * found[0]


def test_accelerators_with_and_without_correction_reach_the_monolithic_history(ship):
    tiny = "mesh.near=4", "mesh.far=6", "time.periods=0.1"
    base = ship("current=2", "coupling=consistent", *tiny)
    base = replace(base, coupling=replace(base.coupling, predictor="quadratic"))

    def heave(scheme, accelerator):
        coupling = replace(base.coupling, scheme=scheme, accelerator=accelerator)
        data = run(replace(base, coupling=coupling)).dataset
        return data.attrs["status"], data["heave"].values

    _, reference = heave("standard", Monolithic(name="monolithic"))
    for scheme in ("standard", "corrected", "consistent"):
        for name, accelerator in ACCELERATORS.items():
            status, found = heave(scheme, accelerator)
            if name == "none" and scheme != "consistent":
                assert status == "diverged"
                continue
            assert status == "completed", (scheme, name)
            # A relaxed iteration stops within tolerance/(1 - g), g up to 0.9; errors of the
            # acceleration add up twice over 7 steps.
            assert np.abs(found - reference).max() < 7**2 * 10 * 1e-10, (scheme, name)
