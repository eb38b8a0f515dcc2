"""The few numbers by which a reader compares runs of a kind."""

from collections.abc import Callable, Mapping
from typing import Any

import numpy as np
from h5netcdf import File

Headline = dict[str, Any]


def _series(*names: str) -> Callable[[File], Headline]:
    """First, least, greatest and last finite value over time of each of `names`."""

    def read(file: File) -> Headline:
        found: Headline = {"steps": len(file.variables["time"]) - 1}
        for name in names:
            values = np.asarray(file.variables[name][...], float)
            values = values[np.isfinite(values)]
            if values.size:
                found |= {f"{name}_min": values.min(), f"{name}_max": values.max()}
                found[f"{name}_last"] = values[-1]
        return found

    return read


def _other_modes(file: File) -> Headline:
    """Least, greatest and last surge and pitch, where the ship is free in them."""
    modes = str(file.attrs.get("modes", "")).split()
    return _series(*(mode for mode in ("surge", "pitch") if mode in modes))(file)


def _ends(*names: str) -> Callable[[File], Headline]:
    """Least or greatest finite value of variables, named by both: `clearance_min`."""

    def read(file: File) -> Headline:
        found: Headline = {}
        for name in names:
            variable, _, end = name.rpartition("_")
            if variable in file.variables:
                values = np.asarray(file.variables[variable][...], float)
                values = values[np.isfinite(values)]
                found |= {name: getattr(values, end)()} if values.size else {}
        return found

    return read


def _labelled(label: str, **errors: str) -> Callable[[File], Headline]:
    """Values over `label`, named by variable and label, with their errors: variables by values."""

    def read(file: File) -> Headline:
        labels = np.asarray(file.variables[label][...]).astype(str)
        found: Headline = {}
        for name, error in errors.items():
            columns = (file.variables[variable][...] for variable in (name, error))
            for one, value, uncertain in zip(labels, *columns, strict=True):
                key = f"{name}_{one.lower()}"
                found |= {key: value, f"{key}_error": uncertain}
        return found

    return read


def _recommended(file: File) -> Headline:
    names = ("recommended_size", "recommended_distance")
    return {name: file.attrs[name] for name in names}


def _safe(file: File) -> Headline:
    return {"safe_share": float(np.mean(file.variables["outcome"][...] == 0))}


def _iterations(file: File) -> Headline:
    counts = np.asarray(file.variables["iterations"][...])[1:]
    if not counts.size:
        return {}
    return {"iterations_mean": float(counts.mean()), "iterations_max": int(counts.max())}


def _diagonal(file: File, matrix: str) -> Headline:
    """Diagonal of a matrix over the modes, by the names of the figures."""
    modes = np.asarray(file.variables["mode_i"][...]).astype(str)
    entries = np.asarray(file.variables[matrix][...])
    return {f"added_mass_{mode}": entries[i, i] for i, mode in enumerate(modes)}


def _matrix(file: File) -> Headline:
    return _diagonal(file, "added_mass")


def _scalars(file: File) -> Headline:
    found: Headline = {}
    for name, variable in file.variables.items():
        if variable.shape == () and np.dtype(variable.dtype).kind == "f":
            found[name] = variable[...].item()
    return found


_LIMITS, _BOTH = ("2d", "dynamic"), ("min", "max")
_OF_KIND: Mapping[str, tuple[Callable[[File], Headline], ...]] = {
    "piston": (_series("position"), _iterations),
    "transient": (_series("heave"), _other_modes, _ends("clearance_min"), _iterations),
    "added_mass": (_matrix,),
    "sensitivity": (_recommended,),
    "mesh": (_ends("face_angle_min", "face_quality_min", "moved_quality_min"),),
    "reduced": (_ends("round_size_max", "round_bound_min"),),
    "limits": (_labelled("limit", limit_speed="limit_error"),),
    "limits_map": (_ends(*(f"limit_{kind}_{end}" for kind in _LIMITS for end in _BOTH)),),
    "hull_shapes": (_labelled("hull", **{f"limit_{k}": f"limit_{k}_error" for k in _LIMITS}),),
    "uneven_bottom": (_ends("squat_speed_min", "squat_speed_max"),),
    "stability_map": (_safe,),
}


def units(figure: str, file: File) -> str | None:
    """Units of the variable that the headline `figure` is taken from; None for a mere count."""
    variables = file.variables
    entries = _diagonal(file, "entry_units") if "entry_units" in variables else {}
    if figure in entries:
        return str(np.asarray(entries[figure]).astype(str))
    names = [name for name in variables if figure == name or figure.startswith(f"{name}_")]
    return str(variables[max(names, key=len)].attrs["units"]) if names else None


def headline(kind: str, file: File) -> Headline:
    """All real scalars of `file`, and for some kinds extremes, diagonals, values by their labels.

    Tables (kinds `inertia`, `iterations`, `race`, `convergence`) have no figure that stands for
    them.
    """
    found = _scalars(file)
    for part in _OF_KIND.get(kind, ()):
        found |= part(file)
    return found
