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


_OF_KIND: Mapping[str, tuple[Callable[[File], Headline], ...]] = {
    "piston": (_series("position"), _iterations),
    "transient": (_series("heave"), _iterations),
    "added_mass": (_matrix,),
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
    """All real scalars of `file`, and for some kinds extremes of series and diagonals."""
    found = _scalars(file)
    for part in _OF_KIND.get(kind, ()):
        found |= part(file)
    return found
