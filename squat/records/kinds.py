"""Every kind of dataset that squat writes: the names and units on one page."""

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
        "iterations": Variable(_TIME, "1", "structure solves of the step"),
        "contraction": Variable(_TIME, "1", "measured contraction factor of the iteration"),
        "residual": Variable(("time", "iteration"), "m", "|w^{k+1} - w^k| of every iteration"),
        "failed_residual": Variable(
            ("failed_iteration",), "m", "residuals of the step that did not converge"
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
        "mean_iterations": Variable(_CELL, "1", "structure solves, mean over the steps"),
        "predicted_iterations": Variable(_CELL, "1", "the same predicted from G and Eq. (5)"),
        "contraction": Variable(_CELL, "1", "measured contraction factor, first step"),
        "predicted_contraction": Variable(_CELL, "1", "amplification factor G"),
        "steps": Variable(_CELL, "1", "converged time steps"),
        "status": Variable(_CELL, "1", "how the run ended"),
        "density_mean_iterations": Variable(
            ("density_added_mass_ratio", "density"), "1", "structure solves, mean over the steps"
        ),
        "density_predicted_contraction": Variable(
            ("density_added_mass_ratio", "density"), "1", "amplification factor G"
        ),
        "curve_mass_ratio": Variable(("curve_mass_ratio",), "1", "m_f/m of the predicted curves"),
        "curve_iterations": Variable(
            ("added_mass_ratio", "curve_mass_ratio"), "1", "predicted mean iterations"
        ),
        "integrator": Variable(("integrator",), "1", "time integrator"),
        "observed_order": Variable(
            ("integrator",), "1", "order in time towards Eq. (5), from two step sizes"
        ),
    },
)

EQUILIBRIA = Kind(
    "equilibria",
    1,
    "Squat equilibria of the one-dimensional model, Eq. (27)",
    {
        "speed": Variable(("speed",), "m s-1", "current V_inf relative to the ship"),
        "stable": Variable(("speed",), "m", "upper root of Eq. (27): stable sinkage w"),
        "unstable": Variable(("speed",), "m", "lower root of Eq. (27): unstable sinkage w"),
        "unphysical": Variable(("speed",), "m", "third root of Eq. (27), below the bottom"),
        "stable_stiffness": Variable(("speed",), "N m-2", "restoring slope -dF/dw at `stable`"),
        "unstable_stiffness": Variable(("speed",), "N m-2", "restoring slope at `unstable`"),
        "period": Variable(("speed",), "s", "linear heave period about `stable`"),
        "case_speed": Variable(("case_speed",), "m s-1", "speeds of Table 7"),
        "case_stable": Variable(("case_speed",), "m", "upper root at the speeds of Table 7"),
        "case_unstable": Variable(("case_speed",), "m", "lower root at the speeds of Table 7"),
        "squat_speed": Variable((), "m s-1", "speed at which both roots merge"),
        "squat_sinkage": Variable((), "m", "the double root at the squat speed"),
    },
)

KINDS = {kind.name: kind for kind in (PISTON, ITERATIONS, EQUILIBRIA)}
