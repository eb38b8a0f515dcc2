"""Kinds of dataset about the coupling itself."""

from squat.records.schema import Kind, Variable

_TIME = ("time",)
_MODES = ("time", "mode")
COUPLED = Kind(
    "coupled",
    1,
    "Coupling of a user's structure with a user's force",
    {
        "time": Variable(_TIME, "s", "time of the accepted steps"),
        "mode": Variable(("mode",), "1", "degree of freedom"),
        "mode_i": Variable(("mode_i",), "1", "degree of freedom that the force acts on"),
        "mode_j": Variable(("mode_j",), "1", "degree of freedom that accelerates"),
        "position": Variable(_MODES, "m", "position q; rad where a mode turns"),
        "velocity": Variable(_MODES, "m s-1", "velocity q'"),
        "acceleration": Variable(_MODES, "m s-2", "acceleration q''"),
        "fluid_force": Variable(
            _MODES, "N", "force of the fluid in the accepted iterate; NaN: not asked"
        ),
        "iterations": Variable(_TIME, "1", "structure solves of the step; 0 at t = 0, no step"),
        "contraction": Variable(
            _TIME, "1", "measured contraction factor of the iteration; NaN: too few iterations"
        ),
        "residual": Variable(
            ("time", "iteration"), "m", "|q^{k+1} - q^k| of every iteration; NaN: fewer were needed"
        ),
        "failed_residual": Variable(
            ("failed_iteration",),
            "m",
            "residuals of the step that did not converge; NaN: out of reach; inf: overflow",
        ),
        "failed_contraction": Variable(
            (), "1", "contraction of the step that did not converge; NaN: too few"
        ),
        "effective_added_mass": Variable(
            ("mode_i", "mode_j"),
            "kg",
            "-dF/dq'' of the fluid, estimated from the first iterates; NaN: not estimated",
        ),
        "added_mass": Variable(("mode_i", "mode_j"), "kg", "m_add of the scheme"),
        "predicted_contraction": Variable(
            (),
            "1",
            "G from the estimate; of n modes the eigenvalue of greatest modulus; NaN: none",
        ),
        "time_step": Variable((), "s", "time step"),
    },
    ("status", "scheme", "accelerator", "integrator", "predictor", "tolerance"),
)

_HEAT = ("problem", "integrator", "mass_ratio", "steps_per_period")
_RACED = (*_HEAT, "scheme", "accelerator")
RACE = Kind(
    "race",
    1,
    "Iterations of every coupling scheme with every accelerator, on piston and ship",
    {
        "problem": Variable(
            ("problem",), "1", "piston in the U-tube; piston on a spring; ship on curves"
        ),
        "integrator": Variable(
            ("integrator",), "1", "newmark with backward d phi/dt, centred with centred"
        ),
        "mass_ratio": Variable(("mass_ratio",), "1", "m_f/m; for the ship c(w(0))/m"),
        "steps_per_period": Variable(
            ("steps_per_period",), "1", "time steps in a period of the coupled oscillation"
        ),
        "scheme": Variable(
            ("scheme",), "1", "m_add: none; the paper's, m_f or Eq. (23); beta c, refreshed"
        ),
        "accelerator": Variable(("accelerator",), "1", "update of the iteration"),
        "factor": Variable(("factor",), "1", "m_add over beta c, constant, in the sweep"),
        "time_step": Variable(("problem", "mass_ratio", "steps_per_period"), "s", "time step"),
        "hull_density": Variable(
            ("mass_ratio",), "kg m-3", "ship mass over the volume below the water line"
        ),
        "mean_iterations": Variable(
            _RACED, "1", "structure solves a step; NaN unless all steps converged"
        ),
        "status": Variable(_RACED, "1", "how the run ended"),
        "difference": Variable(
            _RACED,
            "1",
            "distance from the monolithic history, over the displacement; NaN: not converged",
        ),
        "contraction": Variable(
            (*_HEAT, "scheme"),
            "1",
            "measured factor of the first step, without acceleration; NaN: too few iterations",
        ),
        "predicted_contraction": Variable((*_HEAT, "scheme"), "1", "G of the first step"),
        "factor_iterations": Variable(
            ("problem", "factor", "accelerator"),
            "1",
            "structure solves a step with that m_add; NaN unless all steps converged",
        ),
        "factor_predicted_contraction": Variable(("problem", "factor"), "1", "G with that m_add"),
    },
    ("factor_mass_ratio", "factor_steps", "current", "tolerance"),
)
