"""The two sensitivity studies that section 3.5 mentions: mesh size, and distance of In and Out."""

from collections.abc import Iterator
from dataclasses import replace
from typing import Annotated, Any

import numpy as np
import xarray as xr
from pydantic import Field
from pydantic.dataclasses import dataclass

from squat.channel import AnyHull, Channel
from squat.fluid.accuracy import Accuracy, accurate
from squat.fluid.added_mass import AddedMass
from squat.fluid.inertia import Numbers
from squat.mesh import MeshSize, submesh
from squat.mesh.generate import generate
from squat.progress import progress
from squat.quantities import STRICT, Fraction
from squat.records import build
from squat.records.added_mass_kinds import SENSITIVITY

_HEAVE = 1


@dataclass(frozen=True, kw_only=True, config=STRICT)
class SensitivityCase:
    """What to vary around one hull in one channel.

    Parameters
    ----------
    sizes
        Element sizes at the hull [m], coarsest first.
    distances
        In and Out from bow and stern [m], nearest first; the last stands for infinity.
    tolerance
        Relative error that the recommendation accepts.
    """

    hull: AnyHull
    channel: Channel
    mesh: MeshSize
    accuracy: Accuracy
    sizes: Annotated[Numbers, Field(min_length=2)]
    distances: Annotated[Numbers, Field(min_length=2)]
    tolerance: Fraction


def run(case: SensitivityCase) -> xr.Dataset:
    """Dataset of kind `sensitivity`; its recommendations are attributes."""
    total = 2 * len(case.sizes) + len(case.distances) + 1
    found = list(progress(_works(case), total=total, label="sensitivity"))
    meshes = np.array(found[: 2 * len(case.sizes)]).reshape(2, len(case.sizes), 2)
    limit, *distant = found[2 * len(case.sizes) :]
    i_distance, error = np.array(distant).T
    data = {
        "size": list(case.sizes),
        "growth": ["fixed", "scaled"],
        "size_inertia_coefficient": meshes[..., 0],
        "size_nodes": meshes[..., 1].astype(int),
        "size_limit": limit[0],
        "distance": list(case.distances),
        "distance_inertia_coefficient": i_distance,
        "distance_error": error,
    }
    by_size = np.abs(meshes[0, :, 0] / limit[0] - 1)
    by_distance = np.abs(i_distance / i_distance[-1] - 1)
    advice = {
        "recommended_size": _first(case.sizes, by_size, case.tolerance),
        "recommended_distance": _first(case.distances, by_distance, case.tolerance),
        "tolerance": case.tolerance,
    }
    return build(SENSITIVITY, data, advice)


def _works(case: SensitivityCase) -> Iterator[tuple[float, float]]:
    """Inertia coefficient and nodes of every mesh, then coefficient and error of every channel."""
    circle = np.pi * (case.hull.length / 2) ** 2
    coarse = submesh(case.hull, case.channel)
    for scaled in (False, True):
        for size in case.sizes:
            mesh = generate(coarse, _sized(case.mesh, size, scaled=scaled))
            matrix = AddedMass(mesh, "zero_pressure").matrix
            yield float(matrix[_HEAVE, _HEAVE]) / circle, float(len(mesh.points))
    channels = [
        case.channel,
        *(replace(case.channel, upstream=far, downstream=far) for far in case.distances),
    ]
    for channel in channels:
        value, error = accurate(case.hull, channel, case.accuracy, "zero_pressure")
        yield float(value[_HEAVE, _HEAVE]) / circle, float(error[_HEAVE, _HEAVE]) / circle


def _sized(mesh: MeshSize, near: float, *, scaled: bool) -> MeshSize:
    """`mesh` with another size at the hull; growth and size far away follow where `scaled`."""
    factor = near / mesh.near if scaled else 1.0
    far = max(near, factor * mesh.far)
    return replace(mesh, near=near, far=far, slope=min(factor * mesh.slope, 10.0))


def _first(values: tuple[float, ...], errors: Any, tolerance: float) -> float:
    """First value from which on all errors stay within the tolerance; NaN where none does."""
    inside = np.logical_and.accumulate((errors <= tolerance)[::-1])[::-1]
    return float(values[int(np.argmax(inside))]) if inside.any() else float("nan")
