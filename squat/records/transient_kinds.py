"""The kind of dataset that holds a coupled run."""

from squat.records.added_mass_kinds import ENTRIES, ENTRY_UNITS, MASS, MATRIX
from squat.records.schema import Kind, Variable

_TIME = ("time",)
_CURVE = ("curve_point",)
TRANSIENT = Kind(
    "transient",
    2,
    "Coupled motion of a ship in a current",
    {
        "time": Variable(_TIME, "s", "time of the accepted steps"),
        "phase": Variable(_TIME, "1", "omega t, the paper's axis", label=True),
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
        "iterations": Variable(_TIME, "1", "structure solves of the step; 0 at t = 0, no step"),
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
        "entry_units": ENTRY_UNITS,
        "added_mass_matrix": Variable(
            MATRIX, MASS, f"m_add of Eq. (23) at rest, about the centre of gravity{ENTRIES}"
        ),
        "added_mass": Variable((), "kg m-1", "m_add of Eq. (23) at w = 0"),
        "ship_mass": Variable((), "kg m-1", "mass of the displaced water"),
        "ship_inertia": Variable((), "kg m", "moment of inertia about the centre of gravity"),
        "time_step": Variable((), "s", "time step"),
        "omega": Variable((), "rad s-1", "angular frequency of Eq. (5) with rho g L for 2 rho g S"),
    },
    ("status", "coupling", "current", "free_surface", "force", "model", "modes"),
)
