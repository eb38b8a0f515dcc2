"""Kinds of datasets about the added mass of a hull."""

from collections.abc import Sequence

from squat.records.schema import Kind, Variable

MATRIX = ("mode_i", "mode_j")
MASS = "kg m-1"
ENTRIES = "; kg with one rotation, kg m with two"
ENTRY_UNITS = Variable(MATRIX, "1", "units of each entry of the matrices", False, label=True)
_BY_ROTATIONS = ("kg m-1", "kg", "kg m")


def entry_units(modes: Sequence[str]) -> list[list[str]]:
    """Units of the entries of an added-mass matrix over `modes`: pitch is the one rotation."""
    turns = [mode == "pitch" for mode in modes]
    return [[_BY_ROTATIONS[i + j] for j in turns] for i in turns]


def pressure_units(modes: Sequence[str]) -> list[str]:
    """Units of p_j, pressure over acceleration, of `modes`."""
    return ["kg m-1" if mode == "pitch" else "kg m-2" for mode in modes]


ADDED_MASS = Kind(
    "added_mass",
    1,
    "Added-mass matrix of a hull per unit width, Eqs. (22) to (26)",
    {
        "mode_i": Variable(("mode_i",), "1", "mode that the force acts on"),
        "mode_j": Variable(("mode_j",), "1", "mode that accelerates"),
        "mode": Variable(("mode",), "1", "mode that accelerates"),
        "entry_units": ENTRY_UNITS,
        "added_mass": Variable(MATRIX, MASS, f"added mass, extrapolated{ENTRIES}"),
        "added_mass_error": Variable(MATRIX, MASS, f"absolute error of added_mass{ENTRIES}"),
        "added_mass_mesh": Variable(MATRIX, MASS, f"added mass on the given mesh{ENTRIES}"),
        "added_mass_mesh_error": Variable(
            MATRIX, MASS, f"absolute error of added_mass_mesh{ENTRIES}"
        ),
        "inertia_coefficient": Variable((), "1", "i = m_22/(rho pi a^2), Eq. (28), extrapolated"),
        "inertia_coefficient_error": Variable((), "1", "absolute error of inertia_coefficient"),
        "inertia_coefficient_mesh": Variable((), "1", "i on the given mesh"),
        "ship_mass": Variable((), MASS, "mass of the displaced water"),
        "mass_ratio": Variable((), "1", "m_add/m of heave, extrapolated"),
        "mass_ratio_error": Variable((), "1", "absolute error of mass_ratio", required=False),
        "pressure_units": Variable(
            ("mode",), "1", "units of each mode's pressure", False, label=True
        ),
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
