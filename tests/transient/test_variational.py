"""Runs on the force of the energies: what they share with pressure, and what they keep."""

from dataclasses import replace

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.interpolate import CubicSpline

from squat.coupling import Aitken
from squat.errors import InputError
from squat.transient.parts import prepare
from squat.transient.run import run

VARIATIONAL = "force=variational"
WEIGHT = 1000 * 9.81 * 400 * 10.0  # m g T


def finer(case, factor):
    n = case.time.steps_per_period * factor
    return replace(case, time=replace(case.time, steps_per_period=n))


def residual(data):
    return float(abs(data["energy_residual"]).max())


@pytest.mark.parametrize("surface", ["rigid_lid", "blend"])
def test_energy_momentum_keeps_the_energy_and_newmark_gains_back_second_order(ship, surface):
    keys = VARIATIONAL, "model=curves", "current=2", f"free_surface={surface}", "time.periods=1"
    kept = run(ship("coupling=energy_momentum", *keys)).dataset
    assert kept.attrs["status"] == "completed"
    assert residual(kept) < 1e-13 * WEIGHT
    case = ship("coupling=consistent", *keys)
    gaps = [residual(run(finer(case, factor)).dataset) for factor in (1, 2, 4)]
    assert np.log2(np.array(gaps[:-1]) / gaps[1:]) == pytest.approx(2, abs=0.2)
    assert gaps[0] < 1e-5 * WEIGHT


def test_integrated_pressure_leaves_a_residual_that_no_time_step_removes(ship):
    """Spurious work of the corners' suction: in the audit, not in Fig. 13's balance."""
    case = ship("coupling=consistent", "current=2", "time.periods=0.5")
    gaps = [residual(run(finer(case, factor)).dataset) for factor in (1, 2)]
    assert min(gaps) > 1e-4 * WEIGHT
    assert gaps[1] == pytest.approx(gaps[0], rel=0.2)
    own = run(finer(case, 2)).dataset
    ship_alone = own["kinetic_energy"] + own["potential_energy"] + own["fluid_work"]
    assert float(abs(ship_alone - ship_alone[0]).max()) < 0.02 * gaps[1]


def test_full_flow_and_curves_give_one_history(ship):
    keys = VARIATIONAL, "current=2", "time.periods=0.3"
    for coupling, slack in (("consistent", 1e-7), ("energy_momentum", 1e-7)):
        full, curves = (
            run(ship(f"coupling={coupling}", f"model={model}", *keys)).dataset
            for model in ("full", "curves")
        )
        assert abs(full["heave"] - curves["heave"]).max() < slack
        assert "hull_pressure" in full
        assert "hull_pressure" not in curves
        assert full["hull_pressure"].notnull().all()
        assert residual(full) < (1e-9 if coupling == "energy_momentum" else 1e-6) * WEIGHT


def test_energy_momentum_converges_to_the_ode_with_order_two(ship):
    base = ship(VARIATIONAL, "model=curves", "coupling=energy_momentum", "current=2")
    base = replace(base, time=replace(base.time, periods=0.5))
    parts = prepare(base)
    from squat.dynamics.lagrangian import acceleration

    def rates(t, state):
        return state[1], acceleration(parts.problem.energy, state[:1], state[1:])[0]

    end = 35 * parts.dt
    exact = solve_ivp(rates, (0, end), (base.initial_heave, 0.0), rtol=1e-11, atol=1e-12).y[0, -1]
    errors = [abs(float(run(finer(base, f)).dataset["heave"][-1]) - exact) for f in (1, 2, 4)]
    assert np.log2(np.array(errors[:-1]) / errors[1:]) == pytest.approx(2, abs=0.05)


@pytest.mark.parametrize(
    ("integrator", "scheme"),
    [
        ("centred", "consistent"),
        ("newmark", "consistent"),
        ("backward", "consistent"),
        ("centred", "corrected"),
        ("newmark", "standard"),
        ("centred_backward", "corrected"),
    ],
)
def test_measured_contraction_is_the_predicted_factor_of_beta_one(ship, integrator, scheme):
    keys = f"coupling.integrator={integrator}", f"coupling.scheme={scheme}", "time.periods=0.5"
    data = run(ship(VARIATIONAL, "model=curves", "current=2", *keys)).dataset
    if scheme == "consistent":
        apart = (data["contraction"] - data["predicted_contraction"])[2:]
        assert float(abs(apart).max()) < 1e-5
    else:
        predicted = float(data["predicted_contraction"][0])
        assert float(data["failed_contraction"]) == pytest.approx(predicted, rel=1e-2)
        assert predicted < -1


def test_power_of_the_ends_is_the_rate_of_their_work(ship):
    data = run(ship(VARIATIONAL, "model=curves", "coupling=energy_momentum", "current=2")).dataset
    time, work, power = (data[name].values for name in ("time", "end_work", "end_power"))
    rate = np.gradient(work, time, edge_order=2)[1:-1]
    # Central differences: (omega dt)^2/6 of the greatest.
    assert np.abs(rate - power[1:-1]).max() < 0.01 * np.abs(power).max()
    assert work[0] == 0


def test_audit_of_still_water_has_no_ends(ship):
    data = run(ship(VARIATIONAL, "model=curves", "coupling=energy_momentum", "current=0")).dataset
    assert float(abs(data["end_work"]).max()) == 0
    assert float(abs(data["stream_energy"]).max()) == 0
    start = 1000 * 9.81 * 40 * 0.1**2 / 2
    assert float(data["static_energy"][0]) == pytest.approx(start, rel=1e-8)


def test_grounding_on_curves_is_said_like_any_other(ship):
    keys = VARIATIONAL, "model=curves", "current=3", "time.steps_per_period=1120"
    data = run(ship("coupling=energy_momentum", *keys)).dataset
    assert data.attrs["status"] == "grounded"
    assert 10 + float(data["heave"][-1]) < 0.2


def test_a_step_beyond_the_curves_is_the_ground_not_an_error(ship):
    keys = VARIATIONAL, "model=curves", "current=3", "time.steps_per_period=10", "time.periods=8"
    data = run(ship("coupling=energy_momentum", *keys)).dataset
    assert data.attrs["status"] == "grounded"
    assert data["failed_residual"].size > 0
    assert data.sizes["time"] > 1


@pytest.mark.parametrize(
    ("keys", "message"),
    [
        (("model=curves",), "model=curves: has no pressure; give force=variational"),
        (("coupling=energy_momentum",), "energy_momentum: needs the energies"),
        ((VARIATIONAL, "model=curves", "snapshots=3"), "snapshots=3: model=curves has no field"),
    ],
)
def test_choices_that_exclude_each_other_are_refused_by_name(ship, keys, message):
    with pytest.raises(InputError, match=message):
        ship(*keys)


def test_aitken_carries_the_uncorrected_variational_force(ship):
    """G is -14.6: relaxation, not the force, decides."""
    case = ship(VARIATIONAL, "model=curves", "coupling=newmark", "coupling.scheme=standard")
    calm = Aitken(name="aitken", initial=0.06)
    case = replace(case, time=replace(case.time, periods=0.3))
    data = run(replace(case, coupling=replace(case.coupling, accelerator=calm))).dataset
    assert data.attrs["status"] == "completed"


@pytest.mark.parametrize("keys", [(VARIATIONAL, "model=curves"), ("coupling=printed",)])
def test_the_recorded_curves_hold_the_energy_of_every_step(ship, keys):
    case = ship("current=2.25", "time.periods=0.3", *keys)
    data = run(case).dataset
    heave = data["curve_heave"].values
    mass, potential = (
        CubicSpline(heave, data[f"curve_{name}"].values) for name in ("inertia", "potential")
    )
    w, velocity = data["heave"].values, data["heave_velocity"].values
    kept = (data["initial_energy"] + data["energy_residual"]).values
    well = np.ptp(data["curve_potential"].values[heave > float(data["unstable_equilibrium"])])
    energy = mass(w) * velocity**2 / 2 + potential(w)
    assert energy == pytest.approx(kept, abs=1e-6 * well)
    assert mass(w) == pytest.approx((data["ship_mass"] + data["fluid_inertia"]).values, rel=1e-7)
    own = prepare(replace(case, force="variational")).problem.energy
    for name in ("stable", "unstable"):
        place = np.array([float(data[f"{name}_equilibrium"])])
        assert own.gradient(place) == pytest.approx(0, abs=1e-6 * WEIGHT)
