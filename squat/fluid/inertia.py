"""Inertia coefficient of heave over the geometries of Tables 4 and 5, and two sensitivities."""

from collections.abc import Iterable
from typing import Annotated, Any, Literal, NamedTuple

import numpy as np
import xarray as xr
from pydantic import Field
from pydantic.dataclasses import dataclass

from squat.channel import Channel, Rectangle
from squat.cores import spread
from squat.fluid.accuracy import Accuracy, accurate
from squat.fluid.added_mass import AddedMass
from squat.mesh import MeshSize, submesh
from squat.mesh.generate import generate
from squat.quantities import STRICT, Length, Positive
from squat.records import build
from squat.records.added_mass_kinds import INERTIA

Reading = Literal["depth", "draft"]
Numbers = Annotated[tuple[Positive, ...], Field(min_length=1)]
_HEAVE = 1


@dataclass(frozen=True, kw_only=True, config=STRICT)
class InertiaCells:
    """Rectangles by H/T and a/T, a = L/2.

    Parameters
    ----------
    depth_over_draft, a_over_T
        Rows and columns; all combinations are run.
    deep_a_over_T
        a/T for which deep water (H/T infinite) is wanted too; may be empty.
    deep_depths
        H/T from which deep water is extrapolated in 1/H^2.
    readings
        `depth`: H = `depth` fixed; `draft`: T = `draft` fixed (docs/reproduction.md).
    depth, draft
        The fixed lengths [m].
    distance
        In and Out from bow and stern [m].
    """

    depth_over_draft: Numbers
    a_over_T: Numbers
    deep_a_over_T: tuple[Positive, ...]
    deep_depths: Annotated[tuple[Positive, ...], Field(min_length=3, max_length=3)]
    readings: Annotated[tuple[Reading, ...], Field(min_length=1)]
    depth: Length
    draft: Length
    distance: Length


@dataclass(frozen=True, kw_only=True, config=STRICT)
class InertiaCase:
    """Cells, the mesh of the raw values, and the meshes of the extrapolated ones."""

    cells: InertiaCells
    mesh: MeshSize
    accuracy: Accuracy


class Cell(NamedTuple):
    """One geometry: reading, H/T, a/T, and hull and channel that stand for it."""

    reading: str
    depth_over_draft: float
    a_over_T: float
    hull: Rectangle
    channel: Channel


class Found(NamedTuple):
    """Inertia coefficient: extrapolated, its error, raw, and the raw mesh's nodes."""

    value: float
    error: float
    mesh: float
    nodes: int


def cell(reading: str, ratio: float, a_over_T: float, depth: float, distance: float) -> Cell:
    """Rectangle with H/T = `ratio` in water of `depth` [m]."""
    draft = depth / ratio
    hull = Rectangle(
        shape="rectangle",
        length=2 * a_over_T * draft,
        draft=draft,
        pitch_center="waterline",
    )
    channel = Channel(depth=depth, upstream=distance, downstream=distance)
    return Cell(reading, ratio, a_over_T, hull, channel)


def finite_cells(cells: InertiaCells) -> list[Cell]:
    """All combinations of reading, H/T and a/T."""
    return [
        cell(reading, ratio, a, depth, cells.distance)
        for reading in cells.readings
        for a in cells.a_over_T
        for ratio in cells.depth_over_draft
        for depth in (cells.depth if reading == "depth" else cells.draft * ratio,)
    ]


def deep_cells(cells: InertiaCells) -> list[Cell]:
    """Ever deeper channels for each a/T, In and Out moving away with the bottom; `depth` first."""
    growth = [ratio / cells.deep_depths[0] for ratio in cells.deep_depths]
    return [
        cell("deep", ratio, a, cells.depth * factor, cells.distance * factor)
        for a in cells.deep_a_over_T
        for ratio, factor in zip(cells.deep_depths, growth, strict=True)
    ]


def measure(one: Cell, mesh: MeshSize, accuracy: Accuracy) -> Found:
    """Inertia coefficient (28) of one cell."""
    raw = AddedMass(generate(submesh(one.hull, one.channel), mesh), "zero_pressure")
    value, error = accurate(one.hull, one.channel, accuracy, "zero_pressure")
    circle = np.pi * (one.hull.length / 2) ** 2
    i, i_error, i_mesh = (float(m[_HEAVE, _HEAVE]) / circle for m in (value, error, raw.matrix))
    return Found(i, i_error, i_mesh, len(raw.mesh.points))


def deep_limit(ratios: Iterable[float], found: list[Found]) -> Found:
    """i at H/T -> infinity from i = i_0 + c/H^2 + d/H^4; the error adds the last term's effect."""
    powers = np.vander(1 / np.square(np.array(list(ratios), float)), increasing=True)
    weights = np.linalg.inv(powers)[0]
    short = np.linalg.inv(powers[1:, :2])[0]
    values, errors, meshes = (np.array([f[i] for f in found]) for i in range(3))
    value = float(weights @ values)
    error = abs(value - float(short @ values[1:])) + float(np.abs(weights) @ errors)
    return Found(value, error, float(weights @ meshes), found[-1].nodes)


def run(case: InertiaCase) -> xr.Dataset:
    """Dataset of kind `inertia`: all cells, run over the cores."""
    finite, deep = finite_cells(case.cells), deep_cells(case.cells)
    every = finite + deep
    jobs = ((one, case.mesh, case.accuracy) for one in every)
    found = spread(measure, jobs, "inertia coefficient")
    rows: list[tuple[str, float, float, Found]] = [
        (one.reading, one.depth_over_draft, one.a_over_T, result)
        for one, result in zip(finite, found, strict=False)
    ]
    deeper, n = found[len(finite) :], len(case.cells.deep_depths)
    for i, a in enumerate(case.cells.deep_a_over_T):
        limit = deep_limit(case.cells.deep_depths, deeper[n * i : n * (i + 1)])
        rows.append(("deep", float("inf"), a, limit))
    data: dict[str, Any] = {
        "reading": [row[0] for row in rows],
        "depth_over_draft": [row[1] for row in rows],
        "a_over_T": [row[2] for row in rows],
        "inertia_coefficient": [row[3].value for row in rows],
        "inertia_coefficient_error": [row[3].error for row in rows],
        "inertia_coefficient_mesh": [row[3].mesh for row in rows],
        "mesh_nodes": [row[3].nodes for row in rows],
    }
    return build(INERTIA, data)
