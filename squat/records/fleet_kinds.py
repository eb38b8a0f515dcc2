"""Kinds of datasets about many ships at once."""

from squat.records.schema import Kind, Variable

_POINT, _SPEED = ("initial_heave", "current"), ("current",)
_EDGE = ("edge_current",)

STABILITY_MAP = Kind(
    "stability_map",
    2,
    "Fate of ships released at rest, over current and initial heave",
    {
        "initial_heave": Variable(("initial_heave",), "m", "w(0); the ship is at rest"),
        "current": Variable(_SPEED, "m s-1", "current V_inf relative to the ship"),
        "outcome": Variable(
            _POINT, "1", "0 safe for a whole oscillation, 1 grounded, 2 lifted, 3 undecided"
        ),
        "time_to_grounding": Variable(_POINT, "s", "time of touching the bottom; NaN: never"),
        "least_clearance": Variable(_POINT, "m", "least under-keel clearance of the motion"),
        "energy_gain": Variable(
            _POINT, "J m-1", "energy that the time steps have added since the start"
        ),
        "expected_safe": Variable(_POINT, "1", "1 where the separatrix says safe, else 0"),
        "barrier": Variable(
            _SPEED, "m", "unstable equilibrium, or grounding where that is higher; NaN: no well"
        ),
        "turn": Variable(
            _SPEED,
            "m",
            "highest safe w(0), of the same energy as the barrier; NaN: none, or above the model",
        ),
        "edge_current": Variable(_EDGE, "m s-1", "currents that close in on the 2D squat speed"),
        "edge_barrier": Variable(_EDGE, "m", "barrier at these"),
        "edge_turn": Variable(_EDGE, "m", "turn at these; NaN: beyond the model"),
    },
    ("disagreements", "undecided", "grounding_heave"),
)
