"""Coupled runs against predictions that do not rest on the paper."""

from dataclasses import replace

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from squat.analysis.transient_claims import turning_points
from squat.coupling import Aitken
from squat.errors import InputError
from squat.records import read, read_group
from squat.transient.parts import prepare
from squat.transient.run import run

AITKEN = Aitken(name="aitken", initial=0.3)


def accelerated(case, tolerance=1e-11):
    criterion = replace(case.coupling.criterion, tolerance=tolerance)
    return replace(case, coupling=replace(case.coupling, accelerator=AITKEN, criterion=criterion))


def finer(case, factor):
    n = case.time.steps_per_period * factor
    return replace(case, time=replace(case.time, steps_per_period=n))


def test_run_is_three_linear_periods_of_seventy_steps(ship):
    data = run(ship("current=1", "mesh=paper", "accuracy=default")).dataset
    assert data.attrs["status"] == "completed"
    assert data.sizes["time"] == 211
    assert float(data["time"][-1]) == pytest.approx(41.1, abs=0.05)
    assert float(data["phase"][-1]) == pytest.approx(6 * np.pi)


@pytest.mark.parametrize("current", [0.5, 1, 2, 2.5])
def test_standard_scheme_diverges_in_the_first_step_at_every_speed(ship, current):
    # Short steps keep the first iterates near w(0), where G is predicted.
    small = "time.steps_per_period=280", "time.periods=0.1"
    data = run(ship(f"current={current}", "coupling=printed_standard", *small)).dataset
    assert data.attrs["status"] == "diverged"
    assert data.sizes["time"] == 1
    assert float(data["failed_contraction"]) == pytest.approx(
        float(data["predicted_contraction"][0]), abs=0.01
    )


@pytest.mark.parametrize("coupling", ["printed", "printed_euler", "printed_backward", "newmark"])
@pytest.mark.parametrize("current", [1, 2])
def test_measured_contraction_is_the_predicted_factor(ship, coupling, current):
    data = run(ship(f"current={current}", f"coupling={coupling}", "time.periods=0.3")).dataset
    if data.sizes["time"] > 1:
        apart = data["contraction"] - data["predicted_contraction"]
        assert float(abs(apart).max()) < 0.01
    else:
        predicted = float(data["predicted_contraction"][0])
        assert float(data["failed_contraction"]) == pytest.approx(predicted, abs=0.01)
        assert abs(predicted) > 1


@pytest.mark.parametrize(
    ("integrator", "rate", "beta"),
    [
        ("centred", "centred", 1 / 4),
        ("centred", "backward", 3 / 4),
        ("centred_backward", "backward", 9 / 4),
        ("newmark", "backward", 3 / 4),
        ("newmark", "backward_euler", 1 / 2),
        ("newmark", "trapezoidal", 1.0),
        ("backward", "backward", 9 / 8),
    ],
)
def test_every_pair_of_formulas_has_the_factor_of_its_beta(ship, integrator, rate, beta):
    from squat.dynamics import INTEGRATORS
    from squat.fluid.rates import RATES

    pair = INTEGRATORS[integrator], RATES[rate]
    assert pair[0].s1 * pair[1].s2 / pair[0].s3 == pytest.approx(beta)
    base = ship("current=1", "time.periods=0.02")
    case = replace(
        base, coupling=replace(base.coupling, integrator=integrator, potential_rate=rate)
    )
    data = run(case).dataset
    measured = data["contraction"][1:] if data.sizes["time"] > 1 else data["failed_contraction"]
    assert float(np.ravel(measured)[0]) == pytest.approx(
        float(data["predicted_contraction"][0]), abs=0.01
    )


def test_centred_reading_damps_by_the_predicted_decrement(ship):
    """pi omega dt (1 + m_f/(m + m_f)) an oscillation, to first order in dt, at V = 0."""
    data = run(ship("current=0", "time.periods=8", "time.steps_per_period=140")).dataset
    time, w = data["time"].values, data["heave"].values
    turns = turning_points(time, w)
    extremes = np.abs(np.interp(turns, time, w))
    measured = 2 * np.log(extremes[:-1] / extremes[1:])[1:3].mean()
    mass, inertia = float(data["ship_mass"]), float(data["fluid_inertia"].mean())
    omega = np.sqrt(1000 * 9.81 * 40 / (mass + inertia))
    predicted = np.pi * omega * float(data["time_step"]) * (1 + inertia / (mass + inertia))
    assert measured == pytest.approx(predicted, rel=0.05)


def reference(parts, case, end):
    """w(end) by solve_ivp on the mesh's own pressure force, exact in time."""
    problem, h = parts.problem, 1e-3
    fluid, current = problem.fluid, case.current

    def rates(t, state):
        w, v = state
        q = np.array([w])
        flow = fluid.flow(q, np.array([v]))
        ahead, behind = (fluid.unit_potentials(q + step) for step in (h, -h))
        slope0 = (ahead[0] - behind[0]) / (2 * h)
        slope2 = (ahead[1][0] - behind[1][0]) / (2 * h)
        rate = v * (current * slope0 + v * slope2)
        net = fluid.force(flow, rate)[0] - problem.body.gradient(q)[0]
        inertia = problem.body.mass + fluid.coefficients(q).c[0, 0]
        return v, net / inertia

    solved = solve_ivp(rates, (0, end), (case.initial_heave, 0.0), rtol=1e-8, atol=1e-9)
    return solved.y[0, -1]


@pytest.mark.parametrize(
    ("overrides", "order"),
    [
        (("coupling=newmark",), 2),
        (("coupling=consistent",), 2),
        (("coupling=newmark", "coupling.potential_rate=trapezoidal"), 2),
        (("coupling=newmark", "coupling.integrator=backward"), 2),
        (("coupling=newmark", "coupling.potential_rate=backward_euler"), 1),
        (("coupling=printed",), 1),
    ],
)
def test_refinement_in_time_converges_to_the_ode_with_the_schemes_order(ship, overrides, order):
    base = accelerated(
        ship("current=2", "time.periods=0.5", "mesh.near=4", "mesh.far=6", *overrides)
    )
    parts = prepare(base)
    exact = reference(parts, base, 35 * parts.dt)
    errors = [abs(float(run(finer(base, f)).dataset["heave"][-1]) - exact) for f in (1, 2, 4)]
    slopes = np.log2(np.array(errors[:-1]) / errors[1:])
    assert slopes[-1] == pytest.approx(order, abs=0.35 if order == 2 else 0.25)


def test_work_balance_closes_to_first_order_for_the_centred_and_second_for_newmark(ship):
    """Of the quadrature: w' stands a step behind w in the centred scheme."""
    for name, order in (("printed", 1), ("newmark", 2)):
        gaps = []
        for factor in (1, 2):
            data = run(
                finer(accelerated(ship("current=2", f"coupling={name}", "time.periods=1")), factor)
            )
            record = data.dataset
            total = record["kinetic_energy"] + record["potential_energy"] + record["fluid_work"]
            gaps.append(float(abs(total - total[0]).max()))
        assert np.log2(gaps[0] / gaps[1]) == pytest.approx(order, abs=0.3)


def test_grounded_is_said_of_a_converged_step(ship):
    case = finer(accelerated(ship("current=3", "coupling=newmark"), 1e-8), 4)
    gentle = Aitken(name="aitken", initial=0.05)  # |G| is some 20 close to the bottom
    slots = replace(case.coupling, predictor="quadratic", accelerator=gentle)
    data = run(replace(case, coupling=slots)).dataset
    assert data.attrs["status"] == "grounded"
    assert 10 + float(data["heave"][-1]) < 0.2
    assert 10 + float(data["heave"][-2]) >= 0.2
    assert data["failed_residual"].size == 0


def test_history_does_not_depend_on_what_the_solver_remembers(ship):
    """Fresh factors at every solve give the same history to 1e-9."""
    from squat.fluid import stiffness

    case = ship("current=2", "time.periods=0.3")
    kept = run(case).dataset["heave"].values
    patience = stiffness._PATIENCE
    try:
        stiffness._PATIENCE = 1
        fresh = run(case).dataset["heave"].values
    finally:
        stiffness._PATIENCE = patience
    assert np.abs(kept - fresh).max() < 1e-9


def test_command_writes_record_and_snapshots(squat, tmp_path):
    done = squat(
        "task=transient", "mesh=coarse", "current=2.0", "coupling=printed", "time.periods=0.1",
        "accuracy.near=0.4", "snapshots=3", "out=run.nc",
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    data = read(tmp_path / "run.nc")
    assert data.attrs["status"] == "completed"
    assert data.attrs["coupling"] == "printed"
    assert data.attrs["current"] == 2.0
    assert "phase" in data.coords
    assert data["residual"].dims == ("time", "iteration")
    assert data["hull_pressure"].dims == ("time", "hull_node")
    fields = read_group(tmp_path / "run.nc", "fields")
    assert fields.sizes["time"] == 3
    assert fields["potential"].dtype == np.float32
    bottom = fields["velocity_x"].isel(time=0)
    assert float(bottom.max()) > 2.0


def test_inputs_of_another_geometry_are_refused(squat, tmp_path):
    assert squat("task=mesh", "mesh=coarse", "position.heave=-1", "out=m.nc").returncode == 0
    done = squat("task=transient", "mesh=coarse", "hull.draft=9", "inputs.mesh=m.nc")
    assert done.returncode == 2
    assert "inputs.mesh=m.nc: made for another hull" in done.stderr


def test_inputs_give_the_run_that_is_made_by_hand(ship, tmp_path, squat):
    assert squat("task=mesh", "mesh=coarse", "position.heave=-1", "out=m.nc").returncode == 0
    case = ship("current=1", "time.periods=0.05")
    with_file = replace(case, inputs=replace(case.inputs, mesh=str(tmp_path / "m.nc")))
    assert np.array_equal(run(case).dataset["heave"], run(with_file).dataset["heave"])


def test_zero_pressure_with_current_is_one_line(ship):
    with pytest.raises(InputError, match="free_surface=zero_pressure"):
        run(ship("current=1", "free_surface=zero_pressure"))
