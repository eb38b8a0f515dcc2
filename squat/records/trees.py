"""Nested tuples, named tuples and dataclasses of arrays as plain arrays and back, bit for bit."""

import dataclasses
from importlib import import_module
from typing import Any

import numpy as np
from numpy.typing import NDArray

Leaf = NDArray[Any]


def flatten(value: Any) -> tuple[Any, list[Leaf]]:
    """Structure (JSON values) and arrays of `value`, which `rebuild` makes it from again.

    Parameters
    ----------
    value
        None, bool, int, float, str, NumPy arrays and scalars; tuples, lists and dicts (keyed by
        str) of such; named tuples and dataclasses of squat's own with such fields.

    Raises
    ------
    TypeError
        For anything else: what a run must remember has to be data.
    """
    leaves: list[Leaf] = []
    return _flatten(value, leaves), leaves


def _flatten(value: Any, leaves: list[Leaf]) -> Any:
    if isinstance(value, (np.ndarray, np.generic)):
        leaves.append(np.asarray(value))
        return {"array" if isinstance(value, np.ndarray) else "scalar": len(leaves) - 1}
    if value is None or isinstance(value, (bool, int, float, str)):
        return {"value": value}
    if type(value) in (tuple, list):
        return {type(value).__name__: [_flatten(item, leaves) for item in value]}
    if type(value) is dict:
        return {"dict": {key: _flatten(item, leaves) for key, item in value.items()}}
    fields = {name: _flatten(getattr(value, name), leaves) for name in _fields(type(value))}
    return {"class": f"{type(value).__module__}:{type(value).__qualname__}", "fields": fields}


def _fields(kind: type) -> list[str]:
    if kind.__module__.split(".")[0] == "squat":
        if dataclasses.is_dataclass(kind):
            return [field.name for field in dataclasses.fields(kind) if field.init]
        if issubclass(kind, tuple) and hasattr(kind, "_fields"):
            return list(kind._fields)
    raise TypeError(f"{kind.__qualname__}: not data that a restart could be made from")


def rebuild(structure: Any, leaves: list[Leaf]) -> Any:
    """The value that `flatten` took apart; its arrays are those of `leaves`."""
    ((sort, content), *rest) = structure.items()
    if sort == "value":
        return content
    if sort in ("array", "scalar"):
        return leaves[content] if sort == "array" else leaves[content][()]
    if sort in ("tuple", "list"):
        items = [rebuild(item, leaves) for item in content]
        return tuple(items) if sort == "tuple" else items
    if sort == "dict":
        return {key: rebuild(item, leaves) for key, item in content.items()}
    fields = {name: rebuild(item, leaves) for name, item in rest[0][1].items()}
    return _class(content)(**fields)


def _class(label: str) -> Any:
    module, name = label.split(":")
    if module.split(".")[0] != "squat":
        raise ValueError(f"{label}: not one of squat's classes")
    return getattr(import_module(module), name)


def copy(value: Any) -> Any:
    """`value` as it would come back from disk: the same numbers in arrays of their own."""
    structure, leaves = flatten(value)
    return rebuild(structure, [np.array(leaf) for leaf in leaves])
