"""Units of configuration keys, read from the types that check them."""

import typing
from collections.abc import Iterator
from dataclasses import is_dataclass
from typing import Any

from squat.config.schema import CASES
from squat.quantities import Unit


def unit(task: str, key: str) -> str | None:
    """Unit of a dotted key of `task`; None where its type has none or the key is unknown."""
    kinds = [CASES[task]] if task in CASES else []
    found: list[Any] = []
    for name in key.split("."):
        found = [hints[name] for kind in kinds if name in (hints := _hints(kind))]
        kinds = [part for hint in found for part in _parts(hint)]
    units = {str(kind) for kind in kinds if isinstance(kind, Unit)}
    return units.pop() if len(units) == 1 else None


def _hints(kind: Any) -> dict[str, Any]:
    return typing.get_type_hints(kind, include_extras=True) if is_dataclass(kind) else {}


def _parts(hint: Any) -> Iterator[Any]:
    """The hint itself and all that it is made of: members of unions, metadata of annotations."""
    yield hint
    for part in (*typing.get_args(hint), *getattr(hint, "__metadata__", ())):
        yield from _parts(part)
