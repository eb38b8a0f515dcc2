"""Numbers with their uncertainty: rows of a dataset of kind `convergence`."""

import math
from pathlib import Path
from typing import NamedTuple

from squat import records
from squat.records.stability_kinds import CONVERGENCE
from squat.stability.digits import measured

_UNITS = {"1": "", "m s-1": "m/s"}


class Row(NamedTuple):
    """A number as text: what it is, the values on three levels, their order, and the estimate."""

    name: str
    refined: str
    levels: tuple[str, ...]
    order: str
    estimate: str


def estimates(path: Path) -> list[Row]:
    """Rows of the dataset at `path`.

    Raises
    ------
    InputError
        It is not there, or of another kind.
    """
    data = records.read(path, CONVERGENCE)
    rows = []
    for n in range(data.sizes["quantity"]):
        one = data.isel(quantity=n)
        current, order = float(one["current"]), float(one["observed_order"])
        at = "" if math.isnan(current) else f" at {current:g} m/s"
        unit = str(one["unit"].item())
        rows.append(
            Row(
                f"{one['quantity'].item()}{at}",
                str(one["refined"].item()),
                tuple(_text(value, ".7g") for value in one["level_value"].values),
                _text(order, ".2f"),
                measured(float(one["value"]), float(one["error"]), _UNITS.get(unit, unit)),
            )
        )
    return rows


def _text(value: float, digits: str) -> str:
    return "–" if math.isnan(value) else format(value, digits)
