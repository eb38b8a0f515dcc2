"""What the log's last line says of a dataset: how its run ended, or its answer in short."""

import math
from collections.abc import Callable, Mapping
from pkgutil import resolve_name
from typing import Any

import xarray as xr

_DIGITS = 5
_BOTH = "for heave alone; task=trim for heave and pitch"


def ending(dataset: xr.Dataset, case: Any) -> str:
    """The end of the line, with what comes before it; empty where a dataset has no such."""
    kind = str(dataset.attrs["schema"]).split("/")[1]
    status, summary = (dataset.attrs.get(name) for name in ("status", "summary"))
    said = [f"status {status}"] if status else []
    if kind == "transient":
        said = [f"status {resolve_name('squat.transient.ending:told')(dataset, case)}"]
    elif kind in _SHORT:
        said = [_SHORT[kind](dataset)]
    return "".join(f", {words}" for words in said) + (f"\n{summary}" if summary else "")


def rounded(value: float, error: float, unit: str = "") -> str:
    """`value` to the second digit of its `error`, and to no more than five digits."""
    if not math.isfinite(value):
        return "none"
    digits, known = _DIGITS, math.isfinite(error) and error > 0
    if known and value:
        digits = 2 + math.floor(math.log10(abs(value))) - math.floor(math.log10(error))
    text = f"{value:#.{min(max(digits, 1), _DIGITS)}g}".rstrip(".")
    return " ".join(filter(None, [text, f"+- {error:.2g}" if known else "", unit]))


def _added_mass(dataset: xr.Dataset) -> str:
    mass = float(dataset["ship_mass"])
    parts = []
    for mode in ("heave", "surge"):
        entry = {"mode_i": mode, "mode_j": mode}
        value, error = (
            float(dataset[name].sel(entry)) / mass for name in ("added_mass", "added_mass_error")
        )
        parts.append(f"{mode} {rounded(value, error)}")
    return f"added mass over the ship's mass ({mass:.{_DIGITS}g} kg/m): {', '.join(parts)}"


def _limits(dataset: xr.Dataset) -> str:
    limits = zip(
        dataset["limit"].values,
        dataset["limit_speed"].values,
        dataset["limit_error"].values,
        strict=True,
    )
    parts = [f"{name} {rounded(float(v), float(e), 'm/s')}" for name, v, e in limits]
    return f"limit speeds {', '.join(parts)}, {_BOTH}"


_SHORT: Mapping[str, Callable[[xr.Dataset], str]] = {"added_mass": _added_mass, "limits": _limits}
"""Kinds whose answer fits into a line."""
