"""The kind of dataset that holds a reduced model."""

from dataclasses import replace

from squat.records.mesh_kinds import MESH
from squat.records.schema import Kind, Variable

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
