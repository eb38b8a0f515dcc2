"""Datasets of earlier tasks as inputs of later ones."""

from collections.abc import Collection, Sequence
from pathlib import Path
from typing import Any

import xarray as xr

from squat.errors import InputError
from squat.records.files import read
from squat.records.provenance import config_of, plain
from squat.records.schema import Kind


def read_input(
    name: str, kind: Kind, case: object, parts: Sequence[str], ignoring: Collection[str] = ()
) -> xr.Dataset:
    """Dataset `name` of `kind`, given by the key `inputs.<kind>`.

    Parameters
    ----------
    case
        The case that it serves.
    parts
        Keys that must be the same in `case` and in the dataset's configuration.
    ignoring
        Keys below them that make no difference.

    Raises
    ------
    InputError
        Where the dataset cannot be read, or was made for something else.
    """
    data = read(Path(name), kind)
    made = config_of(data)
    for part in parts:
        if _without(ignoring, made[part]) != _without(ignoring, plain(getattr(case, part))):
            raise InputError(
                f"inputs.{kind.name}={name}: made for another {part}; make it again for this one"
            )
    return data


def _without(keys: Collection[str], part: Any) -> Any:
    if not isinstance(part, dict):
        return part
    return {key: value for key, value in part.items() if key not in keys}
