"""Kinds of datasets about equilibria of the ship and what its energies imply."""

from squat.records.schema import Kind, Variable

_SPEED, _CASE = ("speed",), ("case_speed",)
_LOOP = ("case_speed", "loop_point")

EQUILIBRIA = Kind(
    "equilibria",
    1,
    "Squat equilibria of the one-dimensional model, Eq. (27)",
    {
        "speed": Variable(("speed",), "m s-1", "current V_inf relative to the ship"),
        "stable": Variable(("speed",), "m", "upper root of Eq. (27): stable sinkage w; NaN: none"),
        "unstable": Variable(
            ("speed",), "m", "lower root of Eq. (27): unstable sinkage w; NaN: none"
        ),
        "unphysical": Variable(
            ("speed",), "m", "third root of Eq. (27), below the bottom; NaN: none"
        ),
        "stable_stiffness": Variable(
            ("speed",), "N m-2", "restoring slope -dF/dw at `stable`; NaN: none"
        ),
        "unstable_stiffness": Variable(
            ("speed",), "N m-2", "restoring slope at `unstable`; NaN: none; -inf: on the bottom"
        ),
        "period": Variable(
            ("speed",),
            "s",
            "period of small heave about `stable` with the inertia (1 + added_mass_ratio) m; "
            "longer under a rigid lid; NaN: none",
        ),
        "added_mass_ratio": Variable(
            (), "1", "m_add/m of heave: zero pressure, Eq. (23), or as given", required=False
        ),
        "added_mass_ratio_error": Variable(
            (), "1", "its numerical error; NaN: given", required=False
        ),
        "case_speed": Variable(("case_speed",), "m s-1", "single speeds: Table 7 for its ship"),
        "case_stable": Variable(("case_speed",), "m", "upper root at the single speeds; NaN: none"),
        "case_unstable": Variable(
            ("case_speed",), "m", "lower root at the single speeds; NaN: none"
        ),
        "squat_speed": Variable((), "m s-1", "speed at which both roots merge"),
        "squat_sinkage": Variable((), "m", "the double root at the squat speed"),
    },
)

STABILITY = Kind(
    "stability",
    1,
    "Equilibria, limits, periods and phase portrait of a ship in heave, from its energies",
    {
        "speed": Variable(_SPEED, "m s-1", "current V_inf relative to the ship"),
        "stable": Variable(_SPEED, "m", "stable equilibrium w; NaN: none"),
        "unstable": Variable(_SPEED, "m", "unstable equilibrium w; NaN: none above grounding"),
        "stable_1d": Variable(_SPEED, "m", "upper root of Eq. (27); NaN: none"),
        "unstable_1d": Variable(_SPEED, "m", "lower root of Eq. (27); NaN: none"),
        "linear_period": Variable(_SPEED, "s", "period of small motion about `stable`; NaN: none"),
        "period": Variable(_SPEED, "s", "exact period of the motion from the start; NaN: lost"),
        "lowest": Variable(_SPEED, "m", "deepest w of the motion from the start; NaN: lost"),
        "highest": Variable(_SPEED, "m", "highest w of the motion from the start; NaN: lost"),
        "case_speed": Variable(_CASE, "m s-1", "currents of the portraits"),
        "case_stable": Variable(_CASE, "m", "stable equilibrium at those currents; NaN: none"),
        "case_unstable": Variable(
            _CASE, "m", "barrier there: unstable equilibrium, or grounding; NaN: no well"
        ),
        "case_action": Variable(
            _CASE, "J s m-1", "area inside the separatrix in the plane of w and M w'; NaN: open"
        ),
        "heave": Variable(("heave",), "m", "heave w of the curves over it"),
        "inertia": Variable(("heave",), "kg m-1", "M(w) = m + c(w), ship and water"),
        "potential": Variable(
            ("case_speed", "heave"), "J m-1", "U(w), zero at w = 0 in still water"
        ),
        "separatrix_heave": Variable(
            _LOOP,
            "m",
            "upper half of the separatrix, from the barrier to its turn or the top; NaN: no well",
        ),
        "separatrix_velocity": Variable(
            _LOOP, "m s-1", "w' there; the lower half mirrors it; NaN: no well"
        ),
        "start_heave": Variable((), "m", "w(0) of the start"),
        "start_velocity": Variable((), "m s-1", "w'(0) of the start"),
        "initial_heave": Variable(("initial_heave",), "m", "w(0)"),
        "initial_velocity": Variable(
            ("initial_velocity",), "m s-1", "w'(0); its sign is of no effect"
        ),
        "limit_map": Variable(
            ("initial_heave", "initial_velocity"),
            "m s-1",
            "dynamic squat speed of that start; its contours bound the basins; NaN: out of reach",
        ),
        "squat_speed_1d": Variable((), "m s-1", "1D squat speed, Eq. (27)"),
        "squat_sinkage_1d": Variable((), "m", "w where its roots merge"),
        "squat_speed_2d": Variable((), "m s-1", "2D squat speed: the equilibria merge"),
        "squat_sinkage_2d": Variable((), "m", "w where they merge"),
        "dynamic_squat_speed": Variable((), "m s-1", "least current that loses the start"),
        "ship_mass": Variable((), "kg m-1", "mass of the displaced water"),
    },
    ("free_surface", "squat_speed_bracket"),
)

_LIMIT, _FORMULA = ("limit",), ("formula",)
LIMITS = Kind(
    "limits",
    1,
    "Safe speed of a ship: equilibrium, clearance and limits, with errors and usual formulas",
    {
        "current": Variable((), "m s-1", "speed of the ship through the water that is asked about"),
        "equilibrium": Variable((), "m", "stable equilibrium w at that speed; NaN: none"),
        "equilibrium_error": Variable((), "m", "its numerical error; NaN: not known"),
        "under_keel_clearance": Variable((), "m", "clearance at the equilibrium; NaN: none"),
        "least_clearance": Variable(
            (), "m", "least clearance of the motion from the start; NaN: lost"
        ),
        "least_clearance_error": Variable((), "m", "its numerical error; NaN: not known"),
        "period": Variable((), "s", "exact period of that motion; NaN: lost"),
        "period_error": Variable((), "s", "its numerical error; NaN: not known"),
        "linear_period": Variable(
            (), "s", "period of small motion about the equilibrium; NaN: none"
        ),
        "depth_froude_number": Variable((), "1", "V/sqrt(g H)"),
        "limit": Variable(_LIMIT, "1", "1D: Eq. (27); 2D: the fold; dynamic: from the start"),
        "limit_speed": Variable(_LIMIT, "m s-1", "speed above which the ship is lost"),
        "limit_error": Variable(_LIMIT, "m s-1", "its numerical error; NaN: not known"),
        "limit_froude_number": Variable(_LIMIT, "1", "limit_speed/sqrt(g H)"),
        "limit_local": Variable(
            (), "m s-1", "1D squat speed with the clearance along hull and bottom", required=False
        ),
        "formula": Variable(_FORMULA, "1", "usual formula for squat"),
        "formula_squat": Variable(_FORMULA, "m", "its squat, positive down; NaN: not applicable"),
        "formula_limit": Variable(_FORMULA, "m s-1", "its limit speed; NaN: it has none"),
        "formula_note": Variable(_FORMULA, "1", "why it does not apply, or how it was applied"),
        "formula_source": Variable(_FORMULA, "1", "where it is from"),
        "warning": Variable(("warning",), "1", "what to mind before using these numbers"),
    },
    ("summary", "free_surface"),
)

_CELL = ("length_over_draft", "depth_over_draft")
LIMITS_MAP = Kind(
    "limits_map",
    1,
    "Limits over H/T and L/T",
    {
        "length_over_draft": Variable(("length_over_draft",), "1", "L/T"),
        "depth_over_draft": Variable(("depth_over_draft",), "1", "H/T"),
        "limit_1d": Variable(_CELL, "m s-1", "1D squat speed, Eq. (27)"),
        "limit_2d": Variable(_CELL, "m s-1", "2D squat speed"),
        "limit_2d_error": Variable(_CELL, "m s-1", "its numerical error; NaN: not known"),
        "limit_dynamic": Variable(_CELL, "m s-1", "dynamic squat speed of the start"),
        "limit_dynamic_error": Variable(_CELL, "m s-1", "its numerical error; NaN: not known"),
        "sinkage_1d": Variable(_CELL, "m", "w at the 1D squat speed"),
        "sinkage_2d": Variable(_CELL, "m", "w at the 2D squat speed"),
    },
    ("draft", "start_over_draft"),
)

_HULL = ("hull",)
_OUTLINE = ("hull", "outline_point")
HULL_SHAPES = Kind(
    "hull_shapes",
    1,
    "Hulls of different shape, of one draft and submerged area, in one channel",
    {
        "hull": Variable(_HULL, "1", "name of the hull"),
        "waterline_length": Variable(_HULL, "m", "length of the water plane, at w = 0"),
        "length_overall": Variable(_HULL, "m", "greatest length below the water line"),
        "area": Variable(_HULL, "m2", "submerged area at rest, the same for all"),
        "depth_of_keel": Variable(_HULL, "m", "draft T at rest, the same for all"),
        "block_coefficient": Variable(_HULL, "1", "area/(waterline_length T)"),
        "added_mass_ratio": Variable(_HULL, "1", "m_add/m in heave, zero pressure, Eq. (23)"),
        "added_mass_ratio_error": Variable(_HULL, "1", "its numerical error; NaN: not known"),
        "fluid_mass_ratio": Variable(_HULL, "1", "c(0)/m, the water's inertia under free_surface"),
        "limit_1d": Variable(_HULL, "m s-1", "1D squat speed, Eq. (27), of the box of L and T"),
        "limit_local": Variable(_HULL, "m s-1", "1D squat speed with the clearance along the hull"),
        "limit_2d": Variable(_HULL, "m s-1", "2D squat speed"),
        "limit_2d_error": Variable(_HULL, "m s-1", "its numerical error; NaN: not known"),
        "limit_dynamic": Variable(_HULL, "m s-1", "dynamic squat speed of the start"),
        "limit_dynamic_error": Variable(_HULL, "m s-1", "its numerical error; NaN: not known"),
        "sinkage_1d": Variable(_HULL, "m", "w at the 1D squat speed"),
        "sinkage_2d": Variable(_HULL, "m", "w at the 2D squat speed, finest mesh"),
        "equilibrium": Variable(_HULL, "m", "stable equilibrium w at `current`; NaN: none"),
        "equilibrium_error": Variable(_HULL, "m", "its numerical error; NaN: not known"),
        "period": Variable(_HULL, "s", "period of small heave in still water"),
        "period_error": Variable(_HULL, "s", "its numerical error; NaN: not known"),
        "outline_x": Variable(_OUTLINE, "m", "wetted outline, from the bow; NaN: ended"),
        "outline_z": Variable(
            _OUTLINE, "m", "wetted outline, from the still water line up; NaN: ended"
        ),
        "current": Variable((), "m s-1", "current at which sinkages are compared"),
        "start_heave": Variable((), "m", "w(0) of the start"),
        "start_velocity": Variable((), "m s-1", "w'(0) of the start"),
    },
    ("free_surface",),
)

_QUANTITY = ("quantity",)
CONVERGENCE = Kind(
    "convergence",
    1,
    "Headline numbers on three meshes and with three time steps, with their uncertainty",
    {
        "quantity": Variable(_QUANTITY, "1", "what the numbers of a row are"),
        "current": Variable(_QUANTITY, "m s-1", "current V_inf; NaN: none, or the answer itself"),
        "unit": Variable(_QUANTITY, "1", "unit of the row's values and error"),
        "refined": Variable(_QUANTITY, "1", "what was refined: mesh or time step"),
        "level_value": Variable(
            ("quantity", "level"),
            "1",
            "values from the coarsest to the finest; NaN: none, in `unit`",
        ),
        "observed_order": Variable(_QUANTITY, "1", "observed order; NaN: they do not shrink so"),
        "value": Variable(_QUANTITY, "1", "extrapolated with that order; NaN: none, in `unit`"),
        "error": Variable(_QUANTITY, "1", "grid convergence index, absolute; NaN: none, in `unit`"),
    },
    ("refinement", "safety"),
)
