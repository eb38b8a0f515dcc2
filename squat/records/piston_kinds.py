"""Kinds of datasets about the piston in a U-tube."""

from squat.records.schema import Kind, Variable

_TIME = ("time",)

PISTON = Kind(
    "piston",
    1,
    "Coupled motion of a piston in a U-tube",
    {
        "time": Variable(_TIME, "s", "time of the accepted steps"),
        "position": Variable(_TIME, "m", "displacement w of the piston from equilibrium"),
        "velocity": Variable(_TIME, "m s-1", "velocity of the piston"),
        "acceleration": Variable(_TIME, "m s-2", "acceleration of the piston"),
        "exact_position": Variable(_TIME, "m", "exact displacement, Eq. (5)"),
        "kinetic_energy": Variable(_TIME, "J", "kinetic energy of piston and water"),
        "potential_energy": Variable(_TIME, "J", "potential energy of piston and water"),
        "iterations": Variable(_TIME, "1", "structure solves of the step; 0 at t = 0, no step"),
        "contraction": Variable(
            _TIME, "1", "measured contraction factor of the iteration; NaN: too few iterations"
        ),
        "residual": Variable(
            ("time", "iteration"), "m", "|w^{k+1} - w^k| of every iteration; NaN: fewer were needed"
        ),
        "failed_residual": Variable(
            ("failed_iteration",),
            "m",
            "residuals of the step that did not converge; NaN: out of reach; inf: overflow",
        ),
        "predicted_contraction": Variable((), "1", "amplification factor G in closed form"),
        "time_step": Variable((), "s", "time step"),
    },
    ("status",),
)

_CELL = ("added_mass_ratio", "mass_ratio")
ITERATIONS = Kind(
    "iterations",
    1,
    "Iterations of the coupled piston against mass ratio, added mass and density",
    {
        "mass_ratio": Variable(("mass_ratio",), "1", "m_f/m, fluid mass over piston mass"),
        "added_mass_ratio": Variable(
            ("added_mass_ratio",), "1", "m_add/m_f of the correction; 0: standard scheme"
        ),
        "density": Variable(("density",), "kg m-3", "water density at constant piston mass"),
        "density_added_mass_ratio": Variable(
            ("density_added_mass_ratio",), "1", "m_add/m_f in the sweep of the density"
        ),
        "mean_iterations": Variable(
            _CELL, "1", "structure solves, mean over the steps; inf: not all converged"
        ),
        "predicted_iterations": Variable(
            _CELL, "1", "the same predicted from G and Eq. (5); inf: never"
        ),
        "contraction": Variable(
            _CELL, "1", "measured contraction factor, first step; NaN: too few iterations"
        ),
        "predicted_contraction": Variable(_CELL, "1", "amplification factor G"),
        "steps": Variable(_CELL, "1", "converged time steps"),
        "status": Variable(_CELL, "1", "how the run ended"),
        "density_mean_iterations": Variable(
            ("density_added_mass_ratio", "density"),
            "1",
            "structure solves, mean over the steps; inf: not all converged",
        ),
        "density_predicted_contraction": Variable(
            ("density_added_mass_ratio", "density"), "1", "amplification factor G"
        ),
        "curve_mass_ratio": Variable(("curve_mass_ratio",), "1", "m_f/m of the predicted curves"),
        "curve_iterations": Variable(
            ("added_mass_ratio", "curve_mass_ratio"), "1", "predicted mean iterations; inf: never"
        ),
        "integrator": Variable(("integrator",), "1", "time integrator"),
        "observed_order": Variable(
            ("integrator",), "1", "order in time towards Eq. (5), from two step sizes"
        ),
    },
)
