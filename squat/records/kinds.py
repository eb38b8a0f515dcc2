"""Every kind of dataset that squat writes: the names and units on one page."""

from dataclasses import replace

from squat.records.bottom_kinds import UNEVEN_BOTTOM
from squat.records.coupling_kinds import COUPLED, RACE
from squat.records.fleet_kinds import STABILITY_MAP
from squat.records.schema import Kind, Variable
from squat.records.stability_kinds import CONVERGENCE, HULL_SHAPES, LIMITS, LIMITS_MAP, STABILITY
from squat.records.sweep import SWEEP
from squat.records.trim_kinds import TRIM

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
            _CELL, "1", "structure solves, mean over the steps; NaN: no step converged"
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
            "structure solves, mean over the steps; NaN: no step converged",
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
        "period": Variable(("speed",), "s", "linear heave period about `stable`; NaN: none"),
        "case_speed": Variable(("case_speed",), "m s-1", "speeds of Table 7"),
        "case_stable": Variable(
            ("case_speed",), "m", "upper root at the speeds of Table 7; NaN: none"
        ),
        "case_unstable": Variable(
            ("case_speed",), "m", "lower root at the speeds of Table 7; NaN: none"
        ),
        "squat_speed": Variable((), "m s-1", "speed at which both roots merge"),
        "squat_sinkage": Variable((), "m", "the double root at the squat speed"),
    },
)

_NODE, _FACE, _CORNER = ("node",), ("face",), ("corner",)
MESH = Kind(
    "mesh",
    1,
    "Mesh around a hull in a channel, and the submesh that moves it",
    {
        "topology": Variable((), "1", "UGRID 1.0 topology of the mesh"),
        "node_x": Variable(_NODE, "m", "distance of the node from the bow towards the stern"),
        "node_z": Variable(_NODE, "m", "height of the node above the bottom's level"),
        "face_node": Variable(("face", "three"), "1", "nodes of the triangle, counterclockwise"),
        "face_zone": Variable(_FACE, "1", "coarse triangle that the triangle lies in"),
        "face_quality": Variable(_FACE, "1", "4 sqrt(3) area over the sum of squared sides"),
        "face_angle": Variable(_FACE, "degree", "smallest angle of the triangle"),
        "edge_node": Variable(("edge", "two"), "1", "ends of the boundary edge, water on the left"),
        "edge_boundary": Variable(("edge",), "1", "boundary that the edge belongs to"),
        "boundary": Variable(("boundary",), "1", "names of the boundaries (Fig. 3)"),
        "moved_x": Variable(_NODE, "m", "node_x at the shown position"),
        "moved_z": Variable(_NODE, "m", "node_z at the shown position"),
        "moved_quality": Variable(_FACE, "1", "face_quality at the shown position"),
        "moved_surge": Variable((), "m", "surge of the shown position"),
        "moved_heave": Variable((), "m", "heave of the shown position, positive up"),
        "moved_pitch": Variable((), "rad", "pitch of the shown position, positive bow down"),
        "order": Variable((), "1", "polynomial order meant for the triangles"),
        "corner_x": Variable(_CORNER, "m", "x of the coarse vertex"),
        "corner_z": Variable(_CORNER, "m", "z of the coarse vertex"),
        "corner_role": Variable(
            _CORNER, "1", "0 fixed, 1 rigid with the hull, 2 water line at the hull, 3 follower"
        ),
        "corner_partner": Variable(_CORNER, "1", "hull point that roles 2 and 3 follow"),
        "corner_slope": Variable(_CORNER, "1", "slope dz/dx of a follower's path"),
        "zone_corner": Variable(("zone", "three"), "1", "coarse vertices of the zone"),
        "hull_corner": Variable(("hull_point",), "1", "coarse vertices that are hull points"),
        "keel_corner": Variable(("keel_point",), "1", "those of them nearest to the bottom"),
        "bed_x": Variable(("bed_point",), "m", "x of the bottom's points"),
        "bed_z": Variable(("bed_point",), "m", "z of the bottom's points"),
        "moved_corner_x": Variable(_CORNER, "m", "corner_x at the shown position"),
        "moved_corner_z": Variable(_CORNER, "m", "corner_z at the shown position"),
        "center": Variable(("axis",), "m", "point that pitch turns about, at rest"),
        "axis": Variable(("axis",), "1", "names of the coordinates"),
        "limits": Variable(("limit",), "m", "bounds of the hull's motion"),
        "limit": Variable(("limit",), "1", "names of the bounds"),
    },
)

_MATRIX = ("mode_i", "mode_j")
_MASS = "kg m-1"
_ENTRIES = "; kg with one rotation, kg m with two"
ADDED_MASS = Kind(
    "added_mass",
    1,
    "Added-mass matrix of a hull per unit width, Eqs. (22) to (26)",
    {
        "mode_i": Variable(("mode_i",), "1", "mode that the force acts on"),
        "mode_j": Variable(("mode_j",), "1", "mode that accelerates"),
        "mode": Variable(("mode",), "1", "mode that accelerates"),
        "added_mass": Variable(_MATRIX, _MASS, f"added mass, extrapolated{_ENTRIES}"),
        "added_mass_error": Variable(_MATRIX, _MASS, f"absolute error of added_mass{_ENTRIES}"),
        "added_mass_mesh": Variable(_MATRIX, _MASS, f"added mass on the given mesh{_ENTRIES}"),
        "added_mass_mesh_error": Variable(
            _MATRIX, _MASS, f"absolute error of added_mass_mesh{_ENTRIES}"
        ),
        "inertia_coefficient": Variable((), "1", "i = m_22/(rho pi a^2), Eq. (28), extrapolated"),
        "inertia_coefficient_error": Variable((), "1", "absolute error of inertia_coefficient"),
        "inertia_coefficient_mesh": Variable((), "1", "i on the given mesh"),
        "ship_mass": Variable((), _MASS, "mass of the displaced water"),
        "mass_ratio": Variable((), "1", "m_add/m of heave, extrapolated"),
        "pressure": Variable(
            ("mode", "node"), "kg m-2", "p_j of Eq. (25) per unit acceleration; kg m-1 for rotation"
        ),
        "node_x": Variable(("node",), "m", "x of the mesh's nodes, from the bow"),
        "node_z": Variable(("node",), "m", "z of the mesh's nodes, from the bottom"),
        "face_node": Variable(("face", "corner"), "1", "nodes of each triangle, from 0"),
    },
    ("free_surface",),
)

INERTIA = Kind(
    "inertia",
    1,
    "Inertia coefficient of heave of rectangles, Eq. (28)",
    {
        "reading": Variable(("cell",), "1", "depth: H fixed; draft: T fixed; deep: H/T infinite"),
        "depth_over_draft": Variable(("cell",), "1", "H/T; inf: deep water"),
        "a_over_T": Variable(("cell",), "1", "a/T, half length over draft"),
        "inertia_coefficient": Variable(("cell",), "1", "i, extrapolated"),
        "inertia_coefficient_error": Variable(("cell",), "1", "absolute error of i"),
        "inertia_coefficient_mesh": Variable(("cell",), "1", "i on the given mesh"),
        "mesh_nodes": Variable(("cell",), "1", "nodes of the given mesh"),
    },
)

SENSITIVITY = Kind(
    "sensitivity",
    1,
    "Inertia coefficient against mesh size and against the distance of In and Out",
    {
        "size": Variable(("size",), "m", "element size at the hull"),
        "growth": Variable(
            ("growth",), "1", "fixed: size far away and slope stay; scaled: they follow the size"
        ),
        "size_inertia_coefficient": Variable(("growth", "size"), "1", "i on that mesh"),
        "size_nodes": Variable(("growth", "size"), "1", "nodes of that mesh"),
        "size_limit": Variable((), "1", "i, extrapolated, in the given channel"),
        "distance": Variable(("distance",), "m", "In and Out from bow and stern"),
        "distance_inertia_coefficient": Variable(("distance",), "1", "i, extrapolated"),
        "distance_error": Variable(("distance",), "1", "absolute error of i"),
    },
    ("recommended_size", "recommended_distance", "tolerance"),
)

_CURVE = ("curve_point",)
TRANSIENT = Kind(
    "transient",
    2,
    "Coupled motion of a ship in a current",
    {
        "time": Variable(_TIME, "s", "time of the accepted steps"),
        "phase": Variable(_TIME, "1", "omega t, the paper's axis"),
        "heave": Variable(_TIME, "m", "heave w, positive up"),
        "heave_velocity": Variable(_TIME, "m s-1", "heave velocity"),
        "heave_acceleration": Variable(_TIME, "m s-2", "heave acceleration"),
        "fluid_force": Variable(_TIME, "N m-1", "force of the water, Eq. (15), without weight"),
        "surge": Variable(_TIME, "m", "surge of the centre of gravity, positive to the stern"),
        "surge_velocity": Variable(_TIME, "m s-1", "surge velocity"),
        "surge_acceleration": Variable(_TIME, "m s-2", "surge acceleration"),
        "surge_force": Variable(
            _TIME, "N m-1", "force of the water along x; absent without surge", required=False
        ),
        "pitch": Variable(_TIME, "rad", "pitch about the centre of gravity, positive bow down"),
        "pitch_velocity": Variable(_TIME, "rad s-1", "pitch velocity"),
        "pitch_acceleration": Variable(_TIME, "rad s-2", "pitch acceleration"),
        "pitch_moment": Variable(
            _TIME,
            "N",
            "moment of the water about the centre of gravity; absent without pitch",
            required=False,
        ),
        "clearance": Variable(_TIME, "m", "least height of the hull over the bottom"),
        "iterations": Variable(_TIME, "1", "structure solves of the step"),
        "contraction": Variable(
            _TIME, "1", "measured contraction factor of the iteration; NaN: too few iterations"
        ),
        "predicted_contraction": Variable(
            _TIME, "1", "amplification factor G at this position; NaN: no scheme"
        ),
        "residual": Variable(
            ("time", "iteration"), "m", "|w^{k+1} - w^k| of every iteration; NaN: fewer were needed"
        ),
        "failed_residual": Variable(
            ("failed_iteration",),
            "m",
            "residuals of the step that did not converge; NaN: out of reach; inf: overflow",
        ),
        "failed_contraction": Variable(
            (), "1", "contraction of the step that did not converge; NaN: too few"
        ),
        "kinetic_energy": Variable(_TIME, "J m-1", "E_c = m w'^2/2 of the ship"),
        "potential_energy": Variable(_TIME, "J m-1", "E_p = m g (T + w) of the ship"),
        "fluid_work": Variable(_TIME, "J m-1", "W = -int w' F dt, work of the ship on the water"),
        "fluid_inertia": Variable(_TIME, "kg m-1", "c(w), inertia of the water in heave"),
        "water_energy": Variable(_TIME, "J m-1", "T_f = (V^2 a + 2 V b w' + c w'^2)/2"),
        "static_energy": Variable(_TIME, "J m-1", "U_h + m g w from rest: still water and weight"),
        "stream_energy": Variable(_TIME, "J m-1", "U_B = rho V^2 A_sub/2 from rest"),
        "end_power": Variable(_TIME, "W m-1", "power that enters through In and Out"),
        "end_work": Variable(_TIME, "J m-1", "work of In and Out since t = 0, V (V a + b w')"),
        "energy_residual": Variable(
            _TIME, "J m-1", "energy of ship and water gained since t = 0 less end_work"
        ),
        "initial_energy": Variable(
            (),
            "J m-1",
            "E = q'^T M q'/2 + U at t = 0; energy_residual is its change",
            required=False,
        ),
        "curve_heave": Variable(
            _CURVE,
            "m",
            "heave of the curves; all five only where heave is free alone",
            required=False,
        ),
        "curve_inertia": Variable(
            _CURVE, "kg m-1", "M(w) = m + c(w), inertia of ship and water", required=False
        ),
        "curve_potential": Variable(
            _CURVE, "J m-1", "U(w) at this current; 0 at rest in still water", required=False
        ),
        "stable_equilibrium": Variable(
            (), "m", "highest minimum of U on the run's mesh; NaN: none", required=False
        ),
        "unstable_equilibrium": Variable(
            (), "m", "maximum of U below stable_equilibrium; NaN: none", required=False
        ),
        "hull_pressure": Variable(
            ("time", "hull_node"), "Pa", "pressure less atmospheric", required=False
        ),
        "hull_x": Variable(
            ("hull_node",), "m", "x of the hull's nodes at rest, from the bow", required=False
        ),
        "hull_z": Variable(
            ("hull_node",), "m", "z of the hull's nodes at rest, from the bottom", required=False
        ),
        "stable_root": Variable((), "m", "upper root of Eq. (27) at this current; NaN: none"),
        "unstable_root": Variable((), "m", "lower root of Eq. (27) at this current; NaN: none"),
        "center": Variable(("axis",), "m", "centre of gravity at rest, from bow and bottom"),
        "axis": Variable(("axis",), "1", "names of the coordinates"),
        "mode_i": Variable(("mode_i",), "1", "mode that the force acts on"),
        "mode_j": Variable(("mode_j",), "1", "mode that accelerates"),
        "added_mass_matrix": Variable(
            _MATRIX, _MASS, f"m_add of Eq. (23) at rest, about the centre of gravity{_ENTRIES}"
        ),
        "added_mass": Variable((), "kg m-1", "m_add of Eq. (23) at w = 0"),
        "ship_mass": Variable((), "kg m-1", "mass of the displaced water"),
        "ship_inertia": Variable((), "kg m", "moment of inertia about the centre of gravity"),
        "time_step": Variable((), "s", "time step"),
        "omega": Variable((), "rad s-1", "angular frequency of Eq. (5) with rho g L for 2 rho g S"),
    },
    ("status", "coupling", "current", "free_surface", "force", "model", "modes"),
)

_COARSE = (
    "corner_x",
    "corner_z",
    "corner_role",
    "corner_partner",
    "corner_slope",
    "zone_corner",
    "hull_corner",
    "keel_corner",
    "bed_x",
    "bed_z",
    "center",
    "axis",
    "limits",
    "limit",
)


def _system(name: str, *, required: bool) -> dict[str, Variable]:
    """Variables of one reduced system."""
    i, j = f"{name}_function", f"{name}_other_function"
    parts = {
        "flow": Variable((f"{name}_flow",), "1", "flows: 0 the current's, j that of mode j"),
        "stiffness": Variable(("term", i, j), "1", "projected stiffness of each term"),
        "load": Variable(("load", i), "1", "projected loads: flux, then two a coarse hull edge"),
        "residual": Variable(
            (f"{name}_rank", f"{name}_functional"), "1", "coordinates of the residual's functionals"
        ),
    }
    return {f"{name}_{key}": replace(v, required=required) for key, v in parts.items()}


REDUCED = Kind(
    "reduced",
    1,
    "Reduced model of the potential flows around a hull",
    {
        "mode": Variable(("mode",), "1", "rigid modes that the model spans"),
        "chosen": Variable(("term",), "1", "coefficients of the affine form that are computed"),
        "density": Variable((), "kg m-3", "water density"),
        "box_clearance": Variable((), "1", "least clearance over that at rest"),
        "box_pitch": Variable((), "rad", "largest pitch either way"),
        "box_points": Variable(("direction",), "1", "training positions along clearance and pitch"),
        "round_position": Variable(("round", "mode"), "m", "position solved at; rad for pitch"),
        "round_size": Variable(("round",), "1", "basis functions after the round"),
        "round_bound": Variable(
            ("round",), "1", "largest relative error bound of a field after the round"
        ),
        "floor_clearance": Variable(("floor",), "m", "clearances of floor_share, ascending"),
        "floor_share": Variable(
            ("floor", "flow"), "1", "relative rounding of the full energies, standard deviation"
        ),
        **{name: MESH.variables[name] for name in _COARSE},
        **_system("first", required=True),
        **_system("second", required=False),
    },
    ("free_surface", "full_solves", "nodes"),
)

_ALL = (
    PISTON,
    ITERATIONS,
    EQUILIBRIA,
    MESH,
    ADDED_MASS,
    INERTIA,
    SENSITIVITY,
    TRANSIENT,
    COUPLED,
    REDUCED,
    STABILITY,
    LIMITS,
    LIMITS_MAP,
    HULL_SHAPES,
    CONVERGENCE,
    RACE,
    SWEEP,
    STABILITY_MAP,
    TRIM,
    UNEVEN_BOTTOM,
)
KINDS = {kind.name: kind for kind in _ALL}
