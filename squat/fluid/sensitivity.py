"""The two sensitivity studies that section 3.5 mentions: mesh size, and distance of In and Out."""

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
from squat.records.kinds import SENSITIVITY

_HEAVE = 1


@dataclass(frozen=True, kw_only=True, config=STRICT)
class SensitivityCase:
    """What to vary around one hull in one channel.

    Parameters
    ----------
    sizes
        Element sizes at the hull [m], coarsest first; size far away and slope stay.
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
    circle = np.pi * (case.hull.length / 2) ** 2
    coarse = submesh(case.hull, case.channel)
    total = len(case.sizes) + len(case.distances)
    works = [("size", size) for size in case.sizes]
    works += [("distance", distance) for distance in case.distances]
    found: dict[str, list[Any]] = {"size": [], "distance": []}
    for kind, value in progress(works, total=total, label="sensitivity"):
        if kind == "size":
            sized = replace(case.mesh, near=value, far=max(value, case.mesh.far))
            mesh = generate(coarse, sized)
            matrix = AddedMass(mesh, "zero_pressure").matrix
            found[kind].append((matrix[_HEAVE, _HEAVE] / circle, len(mesh.points)))
        else:
            channel = replace(case.channel, upstream=value, downstream=value)
            estimate = accurate(case.hull, channel, case.accuracy, "zero_pressure")
            found[kind].append([part[_HEAVE, _HEAVE] / circle for part in estimate])
    exact = accurate(case.hull, case.channel, case.accuracy, "zero_pressure")
    i_size, nodes = np.array(found["size"]).T
    i_distance, error = np.array(found["distance"]).T
    limit = exact.value[_HEAVE, _HEAVE] / circle
    data = {
        "size": list(case.sizes),
        "size_inertia_coefficient": i_size,
        "size_nodes": nodes.astype(int),
        "size_limit": limit,
        "distance": list(case.distances),
        "distance_inertia_coefficient": i_distance,
        "distance_error": error,
    }
    advice = {
        "recommended_size": _first(case.sizes, np.abs(i_size / limit - 1), case.tolerance),
        "recommended_distance": _first(
            case.distances, np.abs(i_distance / i_distance[-1] - 1), case.tolerance
        ),
        "tolerance": case.tolerance,
    }
    return build(SENSITIVITY, data, advice)


def _first(values: tuple[float, ...], errors: Any, tolerance: float) -> float:
    """First value from which on all errors stay within the tolerance; NaN where none does."""
    inside = np.logical_and.accumulate((errors <= tolerance)[::-1])[::-1]
    return float(values[int(np.argmax(inside))]) if inside.any() else float("nan")
