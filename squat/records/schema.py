"""What a kind of dataset holds: names, dimensions, units."""

import re
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
import xarray as xr
from numpy.typing import NDArray

from squat.errors import InputError

_EXPLAINED = re.compile(r"; (NaN|-?inf)\b")


@dataclass(frozen=True)
class Variable:
    """One variable of a dataset: its dimensions, UDUNITS string and CF long name.

    What may be not finite says so in its long name: "; NaN: none", "; inf: deep water".
    A `label` is an auxiliary coordinate: it follows what is selected from other variables.
    """

    dims: tuple[str, ...]
    units: str
    long_name: str
    required: bool = True
    label: bool = False

    def unexplained(self, values: NDArray[Any]) -> float | None:
        """First of `values` that is not finite and that the long name does not explain."""
        if values.dtype.kind != "f":
            return None
        explained = [word.lower() for word in _EXPLAINED.findall(self.long_name)]
        strange = values[~np.isfinite(values)].tolist()
        return next((value for value in strange if str(value) not in explained), None)


@dataclass(frozen=True)
class Kind:
    """A kind of dataset; `version` grows when a reader of older files would go wrong."""

    name: str
    version: int
    title: str
    variables: Mapping[str, Variable]
    attributes: tuple[str, ...] = ()

    @property
    def label(self) -> str:
        """The `schema` attribute of a file of this kind."""
        return f"squat/{self.name}/{self.version}"

    def check(self, dataset: xr.Dataset, where: str) -> None:
        """Raise InputError, naming `where`, unless `dataset` is of this kind."""
        for name, variable in self.variables.items():
            if name not in dataset.variables:
                if variable.required:
                    raise InputError(f"{where}: variable {name!r} is missing; {self._remedy}")
                continue
            found = dataset.variables[name]
            if found.dims != variable.dims:
                raise InputError(
                    f"{where}: {name!r} has dimensions {found.dims} in place of "
                    f"{variable.dims}; {self._remedy}"
                )
            if found.attrs.get("units") != variable.units:
                raise InputError(
                    f"{where}: {name!r} is in {found.attrs.get('units')!r} in place of "
                    f"{variable.units!r}; {self._remedy}"
                )
        if missing := [name for name in self.attributes if name not in dataset.attrs]:
            raise InputError(f"{where}: attribute {missing[0]!r} is missing; {self._remedy}")

    @property
    def _remedy(self) -> str:
        return f"write it again with squat task={self.name}"


def build(
    kind: Kind, data: Mapping[str, Any], attributes: Mapping[str, Any] | None = None
) -> xr.Dataset:
    """Dataset of `kind` from plain arrays: dimensions, units and names come from the kind.

    Raises
    ------
    InputError
        Naming a variable that is not finite where its long name does not say what that means:
        a number that cannot be explained is not written.
    """
    for name, values in data.items():
        strange = kind.variables[name].unexplained(np.asarray(values))
        if strange is not None:
            raise InputError(
                f"{kind.name}: {name}={strange} is no result, and nothing is written; "
                "give a milder case, and report this one"
            )
    variables = {
        name: xr.Variable(
            kind.variables[name].dims,
            np.asarray(values),
            {"units": kind.variables[name].units, "long_name": kind.variables[name].long_name},
        )
        for name, values in data.items()
    }
    coordinates = {
        name
        for name, variable in variables.items()
        if variable.dims == (name,) or kind.variables[name].label
    }
    dataset = xr.Dataset(
        {name: value for name, value in variables.items() if name not in coordinates},
        {name: variables[name] for name in coordinates},
        {"title": kind.title, "schema": kind.label, **(attributes or {})},
    )
    kind.check(dataset, kind.name)
    return dataset
