"""What the log's last line says of a dataset: how its run ended, or its answer in short."""

from pkgutil import resolve_name
from typing import Any

import xarray as xr

from squat.stability.digits import measured


def ending(dataset: xr.Dataset, case: Any) -> str:
    """The end of the line, with what comes before it; empty where a dataset has no such."""
    kind = str(dataset.attrs["schema"]).split("/")[1]
    status, summary = (dataset.attrs.get(name) for name in ("status", "summary"))
    said = [f"status {status}"] if status else []
    if kind == "transient":
        said = [f"status {resolve_name('squat.transient.ending:told')(dataset, case)}"]
    elif kind == "piston":
        said = [f"status {status}{_piston(dataset)}"]
    elif kind == "added_mass":
        said = [_added_mass(dataset)]
    elif kind == "mesh":
        said = [_mesh(dataset)]
    return "".join(f", {words}" for words in said) + (f"\n{summary}" if summary else "")


def _piston(dataset: xr.Dataset) -> str:
    solves = dataset["iterations"].values[1:]
    return f", {solves.mean():.4g} iterations a step" if solves.size else ""


def _mesh(dataset: xr.Dataset) -> str:
    rest, moved = (float(dataset[f"{name}_quality"].min()) for name in ("face", "moved"))
    return (
        f"{dataset.sizes['node']} nodes, {dataset.sizes['face']} triangles, "
        f"least quality {rest:.2g} at rest, {moved:.2g} moved"
    )


def _added_mass(dataset: xr.Dataset) -> str:
    mass = float(dataset["ship_mass"])
    parts = []
    for mode in ("heave", "surge"):
        entry = {"mode_i": mode, "mode_j": mode}
        value, error = (
            float(dataset[name].sel(entry)) / mass for name in ("added_mass", "added_mass_error")
        )
        given = float(dataset["added_mass_mesh"].sel(entry)) / mass
        parts.append(f"{mode} {measured(value, error)} (on the given mesh {given:.5g})")
    i, given = (float(dataset[f"inertia_coefficient{end}"]) for end in ("", "_mesh"))
    return (
        f"added mass over the ship's mass ({mass:.6g} kg/m): {', '.join(parts)}; "
        f"inertia coefficient i = {i:.6g} (on the given mesh {given:.5g})"
    )
