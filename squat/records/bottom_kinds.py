"""Kinds of datasets about channels whose bottom is not flat."""

from squat.records.schema import Kind, Variable

_RAMP = ("steepness", "place")
_SLENDER = ("gap_over_length",)
_RISE = ("rise",)


def _loads(prefix: str, dims: tuple[str, ...], where: str) -> dict[str, Variable]:
    """Force and moment, each in two dimensions with an error, in 1D, and in 1D completed."""
    found: dict[str, Variable] = {}
    for name, units, what in (
        ("force", "N m-1", "steady heave force"),
        ("moment", "N", "steady pitch moment about the centre of gravity, positive bow down"),
    ):
        text = f"{what}, {where}"
        found |= {
            f"{prefix}{name}": Variable(dims, units, f"{text}, 2D, extrapolated"),
            f"{prefix}{name}_error": Variable(
                dims, units, f"estimated error of {prefix}{name}; NaN: not known"
            ),
            f"{prefix}{name}_1d": Variable(dims, units, f"{text}, 1D with the local depth"),
            f"{prefix}{name}_complete": Variable(
                dims, units, f"{text}, 1D with ends and curvature; NaN but for boxes"
            ),
        }
    return found


UNEVEN_BOTTOM = Kind(
    "uneven_bottom",
    1,
    "Steady loads and squat speed of a ship held over a shelf",
    {
        "steepness": Variable(("steepness",), "1", "rise of the ramp over its length"),
        "place": Variable(("place",), "m", "x of the ramp's middle from the bow, astern"),
        "gap_over_length": Variable(
            _SLENDER,
            "1",
            "clearance at the foot over ship length, the ramp half as long as the ship",
        ),
        "rise": Variable(_RISE, "m", "height of the shelf, the ramp's middle under mid-length"),
        **_loads("", _RAMP, "ramp at that place"),
        **_loads("slender_", _SLENDER, "ramp of half its length"),
        "squat_speed": Variable(_RISE, "m s-1", "2D squat speed of the level ship, extrapolated"),
        "squat_speed_error": Variable(
            _RISE, "m s-1", "estimated error of squat_speed; NaN: not known"
        ),
        "squat_sinkage": Variable(_RISE, "m", "heave at the 2D squat speed"),
        "squat_speed_1d": Variable(_RISE, "m s-1", "squat speed, 1D with the local depth"),
        "squat_sinkage_1d": Variable(_RISE, "m", "heave at squat_speed_1d"),
        "squat_speed_complete": Variable(
            _RISE, "m s-1", "squat speed, 1D with ends and curvature; NaN but for boxes"
        ),
        "length": Variable((), "m", "length of the ship"),
        "clearance": Variable((), "m", "under-keel clearance over the foot of the ramp"),
        "shelf_rise": Variable((), "m", "height of the shelf of the ramps at many places"),
        "current": Variable((), "m s-1", "current at Out, over the foot of the ramp"),
    },
)
