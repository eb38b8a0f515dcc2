"""Datasets of one kind stacked into arrays with the sweep's dimensions in front."""

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
import xarray as xr
from numpy.typing import NDArray

from squat.records.schema import Kind, Variable
from squat.records.sweep import INDEX

Place = tuple[Any, ...]
Array = NDArray[Any]


def stack(
    source: Kind, datasets: Mapping[Place, xr.Dataset], axes: Sequence[str], shape: Place
) -> tuple[dict[str, Variable], dict[str, Array]]:
    """Declarations and values of all variables of `datasets`, NaN or "" where a job has none.

    Parameters
    ----------
    datasets
        By place in the sweep, of kind `source`.
    axes, shape
        Names and lengths of the sweep's dimensions.

    Notes
    -----
    A coordinate that agrees between all jobs (the shorter are the beginning of the longest) stays
    one-dimensional. One that does not is stacked too, and its dimension is called `<name>_index`.
    """
    first = next(iter(datasets.values()))
    present = [name for name in source.variables if any(name in d for d in datasets.values())]
    common = {name for name in present if name in first.coords and _agree(name, datasets)}
    all_dims = {str(dim) for d in datasets.values() for dim in d.dims}
    apart = {name for name in all_dims if name in present and name not in common}
    sizes = {dim: max(d.sizes.get(dim, 0) for d in datasets.values()) for dim in all_dims}
    variables, data = {}, {}
    for name in present:
        declared = source.variables[name]
        dims = tuple(f"{dim}{INDEX}" if dim in apart else dim for dim in declared.dims)
        lead = () if name in common else tuple(axes)
        values = {place: d[name].values for place, d in datasets.items() if name in d}
        if name in common:
            data[name] = max(values.values(), key=len)
        else:
            own = tuple(sizes[dim] for dim in declared.dims)
            data[name] = _stacked(values, shape, own)
        filled = lead and data[name].dtype.kind == "f"
        meaning = _filled(declared.long_name) if filled else declared.long_name
        variables[name] = Variable(lead + dims, declared.units, meaning)
    return variables, data


def _agree(name: str, datasets: Mapping[Place, xr.Dataset]) -> bool:
    values = [d[name].values for d in datasets.values() if name in d]
    longest = max(values, key=len)
    return all(np.array_equal(value, longest[: len(value)]) for value in values)


def _filled(meaning: str) -> str:
    also = " too" if "; NaN" in meaning else ""
    return f"{meaning}; NaN{also}: no such job, or a shorter one"


def _stacked(values: Mapping[Place, Array], shape: Place, own: Place) -> Array:
    text = next(iter(values.values())).dtype.kind in "OUST"
    table: Array = np.full(shape + own, "", object) if text else np.full(shape + own, np.nan)
    for place, value in values.items():
        inside = tuple(slice(n) for n in value.shape)
        table[place + inside] = value
    return table.astype(str) if text else table
