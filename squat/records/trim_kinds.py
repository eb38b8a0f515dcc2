"""Kinds of datasets about ships that trim."""

from squat.records.schema import Kind, Variable

_POINT = ("point",)
_TRIMMED = ("trimmed_point",)
TRIM = Kind(
    "trim",
    3,
    "Equilibria and limits of a ship in heave and pitch, from its energies",
    {
        "current": Variable(_POINT, "m s-1", "current of the equilibrium, along the branch"),
        "heave": Variable(_POINT, "m", "heave of the equilibrium"),
        "pitch": Variable(_POINT, "rad", "pitch of the equilibrium, positive bow down"),
        "unstable": Variable(_POINT, "1", "modes that give way there: 0 stable, 1 a saddle"),
        "heave_stiffness": Variable(_POINT, "N m-2", "d2U/dw2 of the equilibrium"),
        "pitch_stiffness": Variable(_POINT, "N", "d2U/dtheta2 of the equilibrium"),
        "trimmed_current": Variable(
            _TRIMMED, "m s-1", "current of the equilibria through the lowest pass"
        ),
        "trimmed_heave": Variable(_TRIMMED, "m", "heave of these"),
        "trimmed_pitch": Variable(_TRIMMED, "rad", "pitch of these, positive bow down"),
        "trimmed_unstable": Variable(
            _TRIMMED,
            "1",
            "modes that give way there: 0 stable, 1 a saddle; absent in older files",
            required=False,
        ),
        "length": Variable((), "m", "length of the water plane"),
        "displacement": Variable((), "m2", "submerged area at rest"),
        "squat_speed_1d": Variable((), "m s-1", "1D squat speed, Eq. (27)"),
        "squat_sinkage_1d": Variable((), "m", "w where its roots merge"),
        "squat_speed": Variable((), "m s-1", "2D squat speed, pitch free: the branch's fold"),
        "squat_speed_error": Variable((), "m s-1", "its error, from coarser meshes; NaN: none"),
        "squat_sinkage": Variable((), "m", "heave at the fold"),
        "squat_trim": Variable((), "rad", "pitch at the fold, positive bow down"),
        "heave_only_limit": Variable(
            (),
            "m s-1",
            "dynamic squat speed of the start, pitch locked at start_pitch (task=limits: at zero)",
        ),
        "heave_only_limit_error": Variable(
            (), "m s-1", "its error, from coarser meshes; NaN: none"
        ),
        "safe_speed": Variable((), "m s-1", "current up to which its energy keeps the ship"),
        "safe_speed_error": Variable((), "m s-1", "its error, from coarser meshes; NaN: none"),
        "saddle_heave": Variable((), "m", "heave of the lowest way out at safe_speed"),
        "saddle_pitch": Variable((), "rad", "pitch of the lowest way out at safe_speed"),
        "dynamic_limit": Variable(
            (), "m s-1", "least current that loses the start within the runs; NaN: none"
        ),
        "dynamic_limit_error": Variable(
            (), "m s-1", "half the bracket of dynamic_limit; NaN: none"
        ),
        "greatest_trim": Variable(
            (), "rad", "greatest pitch of the last run that was not lost; NaN: none"
        ),
        "drift": Variable((), "1", "greatest change of energy in it over m g T; NaN: none"),
        "start_heave": Variable((), "m", "w(0) of the start"),
        "start_pitch": Variable((), "rad", "pitch of the start, positive bow down"),
    },
)
