"""Which keys tell runs apart, and their values in a few words."""

from collections.abc import Callable, Mapping

import numpy as np
import pandas as pd

from squat.catalogue.find import RESULT
from squat.catalogue.select import OWN_NAMES, independent, parts, varying

_NAMED = 6
"""Keys that a label has room for."""
_LAST = 99  # more dots than any key has
_EXTENT = ("time.", "snapshots", "restart.")
"""How long and how often: less of a run than what it is."""


def differing(table: pd.DataFrame, *first: str) -> tuple[list[str], str]:
    """What to name runs by: the keys that tell them apart, then what else differs between them.

    Not what follows from a choice, how long a run is, or what some runs lack, unless nothing else
    tells. With the keys what to write after their values: dots where a label has no room for more.
    """
    needed = telling(table, *first)
    others = sorted(set(independent(table)).difference(needed), key=_order(table, *first))
    others = [name for name in others if not (_late(table, name) or name.startswith(RESULT))]
    room = max(_NAMED - len(needed), 0)
    return [*needed, *others[:room]], ", ..." if len(others) > room else ""


def telling(table: pd.DataFrame, *first: str) -> list[str]:
    """The fewest configured keys that tell apart what all of them do.

    A choice comes before its parts, and the key that names one before what it stands for;
    before all come those that are asked for `first`, at the end those that some runs lack, and
    last how long a run is.
    """
    kept: list[str] = []
    groups = 1
    for name in sorted(varying(table), key=_order(table, *first)):
        if name.startswith(RESULT):
            continue
        finer = len(table[[*kept, name]].drop_duplicates())
        if finer > groups:
            kept, groups = [*kept, name], finer
    return kept


def _order(table: pd.DataFrame, *first: str) -> Callable[[str], tuple[int, int]]:
    """The place of a key among those of `table`, as `telling` says."""
    choices, columns = parts(table), list(table.columns)

    def place(name: str) -> tuple[int, int]:
        if name in first:
            return -1, first.index(name)
        late = _late(table, name)
        dots = name.count(".") if name in choices and not late else _LAST + late
        return dots, columns.index(name)

    return place


def _late(table: pd.DataFrame, name: str) -> int:
    """Above zero for a key that tells little of what runs are: a length, or lacking in some."""
    return 2 if name.startswith(_EXTENT) else int(table[name].isna().any())


def named(values: Mapping[str, object], between: str = " = ") -> str:
    """Short names of keys with their values, missing ones left out."""
    return ", ".join(
        f"{_short(key)}{between}" + (f"{value:g}" if isinstance(value, float) else str(value))
        for key, value in values.items()
        if not (isinstance(value, float) and np.isnan(value))
    )


def _short(key: str) -> str:
    """The last word of `key`, of one by which a choice names itself that of the choice."""
    whole = key.rpartition(".")[0] if key.endswith(OWN_NAMES) else key
    return whole.rpartition(".")[2]
