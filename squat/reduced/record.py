"""Reduced models on disk: kind `reduced`, the field basis in a group of its own."""

from dataclasses import replace
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
import xarray as xr

from squat import records
from squat.errors import InputError
from squat.mesh import MODES, Mesh
from squat.mesh.ugrid import coarse_variables, from_dataset, submesh_from, to_dataset
from squat.quantities import Vector
from squat.records.reduced_kinds import REDUCED
from squat.reduced.box import Box, BoxSize
from squat.reduced.fluid import ReducedFluid
from squat.reduced.galerkin import Galerkin
from squat.reduced.greedy import Reduced
from squat.reduced.model import Floor, ReducedModel
from squat.reduced.patch import hull_patch
from squat.water import Water

NAMES = ("first", "second")
"""Of the systems: both flows under a lid in the first, or current and motion apart."""
HULL, FIELDS = "hull", "fields"
"""Groups of the patch beside the hull and of the whole mesh, with the basis on them."""


class Loaded(NamedTuple):
    """A reduced model, and a mesh with the basis functions at its nodes.

    The mesh is the patch beside the hull, or the whole one.
    """

    model: ReducedModel
    mesh: Mesh
    basis: tuple[Vector, ...]

    def fluid(self, water: Water, current: float) -> ReducedFluid:
        """The flow solver in a current [m/s]."""
        return ReducedFluid(self.model, self.mesh, self.basis, water, current)


def on_patch(reduced: Reduced, mesh: Mesh) -> Loaded:
    """The model with potentials beside the hull only."""
    patch = hull_patch(mesh)
    return Loaded(
        reduced.model,
        patch.mesh,
        tuple(np.ascontiguousarray(V[:, patch.nodes]) for V in reduced.basis),
    )


def to_record(reduced: Reduced, nodes: int) -> xr.Dataset:
    """Dataset of kind `reduced`, made on a mesh of `nodes` nodes; no field basis."""
    model, rounds = reduced.model, reduced.rounds
    data: dict[str, Any] = {
        "mode": list(model.modes),
        "chosen": model.chosen,
        "density": model.density,
        "box_clearance": model.box.size.clearance,
        "box_pitch": model.box.size.pitch,
        "box_points": [model.box.size.points, model.box.size.pitch_points],
        "round_position": [found.position for found in rounds],
        "round_size": [found.size for found in rounds],
        "round_bound": [found.worst for found in rounds],
        "floor_clearance": model.floor.clearance,
        "floor_share": model.floor.share,
        **coarse_variables(model.box.submesh),
    }
    for name, system in zip(NAMES, model.systems, strict=False):
        data |= {
            f"{name}_flow": system.flows,
            f"{name}_stiffness": system.stiffness,
            f"{name}_load": system.loads,
            f"{name}_residual": system.residual,
        }
    how = {"free_surface": model.free_surface, "full_solves": len(rounds), "nodes": nodes}
    return records.build(REDUCED, data, how)


def fields_record(mesh: Mesh, basis: tuple[Vector, ...]) -> xr.Dataset:
    """A mesh, whole or beside the hull, and the basis functions (N, nodes) on it."""
    whole = replace(mesh, submesh=replace(mesh.submesh, modes=MODES))
    dataset = to_dataset(whole, np.zeros(len(MODES)))
    for name, functions in zip(NAMES, basis, strict=False):
        dataset[f"{name}_basis"] = xr.Variable(
            (f"{name}_function", "node"),
            functions,
            {"units": "1", "long_name": "basis functions at the nodes"},
        )
    return dataset


def load(path: Path, *, fields: bool = False) -> Loaded:
    """The reduced model in a file, with potentials beside the hull or, for `fields`, everywhere.

    Raises
    ------
    InputError
        Where the file holds no reduced model, or no field basis.
    """
    dataset = records.read(path, REDUCED)
    try:
        group = records.read_group(path, FIELDS if fields else HULL)
    except InputError as error:
        raise InputError(
            f"{path}: holds no field basis; make it with squat task=reduced fields=true"
        ) from error
    model = from_record(dataset)
    basis = tuple(group[f"{name}_basis"].values for name in _names(dataset))
    return Loaded(model, from_dataset(group, model.modes), basis)


def from_record(dataset: xr.Dataset) -> ReducedModel:
    """The model of `to_record`: energies, slopes and bounds, no fields."""
    points, pitch_points = (int(n) for n in dataset["box_points"].values)
    size = BoxSize(
        clearance=float(dataset["box_clearance"]),
        pitch=float(dataset["box_pitch"]),
        points=points,
        pitch_points=pitch_points,
    )
    modes = tuple(str(mode) for mode in dataset["mode"].values)
    return ReducedModel(
        Box(submesh_from(dataset, modes), size),
        float(dataset["density"]),
        dataset.attrs["free_surface"],
        dataset["chosen"].values,
        tuple(_system(dataset, name) for name in _names(dataset)),
        Floor(dataset["floor_clearance"].values, dataset["floor_share"].values),
    )


def _names(dataset: xr.Dataset) -> list[str]:
    return [name for name in NAMES if f"{name}_flow" in dataset.variables]


def _system(dataset: xr.Dataset, name: str) -> Galerkin:
    parts = ("flow", "stiffness", "load", "residual")
    return Galerkin(*(dataset[f"{name}_{part}"].values for part in parts))
