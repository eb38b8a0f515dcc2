"""The piston against Eq. (5): order, energy, damping."""

from dataclasses import replace

import numpy as np
import pytest

from squat.errors import InputError
from squat.piston import run
from squat.piston.piston import Oscillator
from squat.piston.study import predict, steps, study, with_density, with_ratios


def error(case):
    data = run(case)
    return float(abs(data["position"] - data["exact_position"]).max())


def refined(case, n):
    return replace(case, time=replace(case.time, steps_per_period=n))


@pytest.mark.parametrize("scheme", ["standard", "corrected"])
def test_newmark_is_second_order_towards_eq_5(case, scheme):
    base = case("piston", f"scheme={scheme}", "piston.mass_ratio=0.5")
    errors = [error(refined(base, n)) for n in (35, 70, 140, 280)]
    orders = np.log2(np.array(errors[:-1]) / errors[1:])
    # The phase error is (omega dt)^2/12 to leading order, with a relative (omega dt)^2 after it.
    assert orders == pytest.approx(2, abs=0.02)


def test_newmark_phase_error_is_the_one_theory_gives(case):
    """Period elongation of the trapezoidal rule: (omega dt)^2/12."""
    base = refined(case("piston"), 100)
    x = 2 * np.pi / 100
    last_zero = 275  # the error is greatest where the motion is fastest
    delay = base.oscillator.omega * base.dt * last_zero * (x**2 / 12)
    amplitude = base.piston.initial_position
    assert error(base) == pytest.approx(amplitude * abs(np.sin(delay)), rel=0.02)


def test_centred_is_first_order_because_its_force_stands_at_the_new_level(case):
    base = case("piston", "integrator=centred", "piston.mass_ratio=0.5", "time.periods=1")
    errors = [error(refined(base, n)) for n in (280, 560, 1120)]
    orders = np.log2(np.array(errors[:-1]) / errors[1:])
    assert orders == pytest.approx(1, abs=0.05)


def test_centred_damps_by_the_modulus_of_its_roots(case):
    """(1 + x^2) z^2 - 2 z + 1 = 0 has |z|^2 = 1/(1 + x^2), x = omega dt."""
    base = case("piston", "integrator=centred", "time.periods=4")
    position = run(base)["position"].values
    n = base.time.steps_per_period
    x = 2 * np.pi / n
    angle = np.arctan(x)  # roots (1 +- i x)/(1 + x^2)
    k = np.arange(position.size)
    decay = (1 + x**2) ** (-k / 2)
    design = np.stack([decay * np.cos(angle * k), decay * np.sin(angle * k)], axis=1)
    fit = np.linalg.lstsq(design, position, rcond=None)[0]
    assert abs(design @ fit - position).max() < 1e-11 * abs(position).max() * position.size


@pytest.mark.parametrize("mass_ratio", [0.2, 1.0, 10.0])
def test_newmark_keeps_the_energy_of_the_coupled_oscillator(case, mass_ratio):
    base = case("piston", f"piston.mass_ratio={mass_ratio}", "time.periods=30")
    data = run(base)
    energy = (data["kinetic_energy"] + data["potential_energy"]).values
    steps_taken = energy.size
    # Each step may leave the iteration's tolerance (relative 1e-12) and rounding behind.
    assert abs(energy / energy[0] - 1).max() < 2e-12 * steps_taken


def test_exact_solution_satisfies_eq_4(case):
    problem = case("piston", "piston.initial_velocity=0.3").oscillator
    start = problem.start(0.01, 0.3)
    t = np.linspace(0, 1, 7)
    h = 1e-4
    w = problem.exact(np.stack([t - h, t, t + h]), start)
    acceleration = (w[0] - 2 * w[1] + w[2]) / h**2
    residual = (problem.piston_mass + problem.fluid_mass) * acceleration + problem.stiffness * w[1]
    assert abs(residual).max() < 1e-6 * problem.stiffness * abs(w).max() * 10


def test_dynamics_in_time_over_period_depends_on_no_density(case):
    """At equal mass ratio, density only scales the force: the same motion in t/T."""
    light, heavy = (case("piston", f"water.density={rho}") for rho in (10, 10000))
    assert run(light)["position"].values == pytest.approx(run(heavy)["position"].values, abs=1e-14)


def test_density_sweep_keeps_the_piston_mass(case):
    base = case("piston")
    thin = with_density(base, 250.0, 0.0)
    assert thin.oscillator.piston_mass == pytest.approx(base.oscillator.piston_mass)
    assert thin.oscillator.fluid_mass == pytest.approx(base.oscillator.fluid_mass / 4)
    assert thin.scheme == "standard"


@pytest.mark.parametrize("mass_ratio", [0.2, 0.66, 0.9])
@pytest.mark.parametrize("added_mass_ratio", [0.0, 0.5, 2.0])
def test_predicted_iterations_are_the_measured_ones(case, mass_ratio, added_mass_ratio):
    cell = with_ratios(case("piston"), mass_ratio, added_mass_ratio)
    measured = np.mean([step.iterations for step in steps(cell)])
    # Near a reversal w''^n = w''^{n+1} nearly holds; a step or two may count one off.
    assert predict(cell) == pytest.approx(measured, rel=0.01)


def test_diverged_run_keeps_its_residuals_and_does_not_pad_time(case):
    data = run(case("piston", "scheme=standard", "piston.mass_ratio=2"))
    assert data.attrs["status"] == "diverged"
    assert data.sizes["time"] == 1
    assert data["failed_residual"].values[-1] > data["failed_residual"].values[0]


def test_impossible_dt_still_counts(case):
    few = run(case("piston", "criterion.iterations=2"))
    assert few.attrs["status"] == "iteration limit"
    assert few["failed_residual"].size == 2


def test_oscillator_frequency_is_eq_5():
    assert Oscillator(3.0, 1.0, 16.0).omega == 2.0


@pytest.mark.parametrize("mass_ratio", [0.2, 10.0])
def test_energy_momentum_keeps_the_energy_at_any_mass_ratio_and_contracts_as_predicted(
    case, mass_ratio
):
    keys = "integrator=energy_momentum", f"piston.mass_ratio={mass_ratio}", "time.periods=30"
    data = run(case("piston", *keys))
    energy = (data["kinetic_energy"] + data["potential_energy"]).values
    # Rounding of each of 2100 steps, as a random walk.
    assert abs(energy / energy[0] - 1).max() < 4 * 2.2e-16 * np.sqrt(energy.size)
    predicted = float(data["predicted_contraction"])
    assert predicted == pytest.approx(-((2 * np.pi / 70) ** 2) / 4)
    assert data["contraction"].values[1:].mean() == pytest.approx(predicted, rel=1e-6)


def test_energy_momentum_is_second_order_towards_eq_5(case):
    base = case("piston", "integrator=energy_momentum")
    errors = [error(refined(base, n)) for n in (35, 70, 140, 280)]
    assert np.log2(np.array(errors[:-1]) / errors[1:]) == pytest.approx(2, abs=0.02)


def test_iterations_of_a_step_without_iteration_are_not_studied(case):
    with pytest.raises(InputError, match="integrator=energy_momentum: has no iterations"):
        case("iterations", "integrator=energy_momentum")


def test_a_study_tells_cells_that_diverge_by_infinity(case):
    """The iteration converges where |G| < 1, and nowhere else."""
    cells = {
        "mass_ratios": "[0.5,10]",
        "added_mass_ratios": "[0]",
        "densities": "[200]",
        "density_added_mass_ratios": "[1]",
        "curve_points": "2",
    }
    keys = [f"cells.{name}={value}" for name, value in cells.items()]
    data = study(case("iterations", *keys))
    assert np.isinf(data["mean_iterations"]).values.tolist() == [[False, True]]
    assert (abs(data["predicted_contraction"]) < 1).values.tolist() == [[True, False]]
