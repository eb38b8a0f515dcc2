"""Our value of one printed cell."""

from collections.abc import Callable, Mapping
from typing import Any, NamedTuple

import xarray as xr


class Here(NamedTuple):
    """Our value of a cell, and how to judge it.

    `inconsistent` says that a test proves the print wrong, `explained` that the note tells why it
    differs; `columns` are further ones of the row.
    """

    value: float
    note: str = ""
    rounds_down: bool = False
    inconsistent: bool = False
    explained: bool = False
    columns: Mapping[str, Any] = {}


LookUp = Callable[[dict[str, str]], Here]
Reader = Callable[[xr.Dataset], LookUp]
MISSING = Here(float("nan"))
"""A cell that the dataset does not hold."""
