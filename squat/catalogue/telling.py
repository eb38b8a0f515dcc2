"""Which keys tell runs apart, and their values in a few words."""

from collections.abc import Mapping

import numpy as np
import pandas as pd

from squat.catalogue.find import RESULT
from squat.catalogue.select import OWN_NAMES, parts, varying

_LAST = 99  # more dots than any key has
_EXTENT = ("time.", "snapshots", "restart.")
"""How long and how often: less of a run than what it is."""


def telling(table: pd.DataFrame, *first: str) -> list[str]:
    """The fewest configured keys that tell apart what all of them do.

    A choice comes before its parts, and the key that names one before what it stands for;
    before all come those that are asked for `first`, at the end those that some runs lack, and
    last how long a run is.
    """
    choices = parts(table)

    def place(name: str) -> int:
        if name in first:
            return -1
        if name.startswith(_EXTENT):
            return _LAST + 2
        lacking = table[name].isna().any()
        return name.count(".") if name in choices and not lacking else _LAST + int(lacking)

    kept: list[str] = []
    groups = 1
    for name in sorted(varying(table), key=place):
        if name.startswith(RESULT):
            continue
        finer = len(table[[*kept, name]].drop_duplicates())
        if finer > groups:
            kept, groups = [*kept, name], finer
    return kept


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
