"""Why no run has what is asked to be compared, and what could be asked instead."""

from collections.abc import Sequence

import pandas as pd
from h5netcdf import File

from squat import catalogue


def variables(file: str) -> dict[str, tuple[str, ...]]:
    """Dimensions of the variables in a file that the catalogue found whole, by their names."""
    with File(file, "r") as opened:
        return {name: tuple(found.dimensions) for name, found in opened.variables.items()}


def remedy(table: pd.DataFrame, variable: str, over: str | None) -> str:
    """One line for runs (of `catalogue.find`) of which none has `variable` and `over` together."""
    own = {name: dims for file in table["file"] for name, dims in variables(file).items()}
    figures = [column for column in table.columns if column.startswith(catalogue.RESULT)]
    asked = {"variable": variable} | ({} if over is None else {"over": over})
    unknown = [key for key, name in asked.items() if name not in own and name not in table.columns]
    if unknown:
        said = " ".join(f"{key}={asked[key]}" for key in unknown)
        names = [*table.columns, *own]
        meant = [found for key in unknown if (found := catalogue.meant(asked[key], names))]
        hint = f" (did you mean {' and '.join(meant)}?)" if meant else ""
        return f"{said}: no run has that{hint}; {_given(table, variable, over, own, figures)}"
    if over is None:
        keys = [key for key in catalogue.varying(table) if key not in figures and key != variable]
        return (
            f"variable={variable}: one value a run; give over=KEY to plot it over what differs, "
            f"as {_listed(keys)}"
        )
    said = f"variable={variable} over={over}"
    name = next((name for name in asked.values() if name not in table.columns), None)
    if name is None or set(asked.values()) <= set(own):
        return f"{said}: no run has both; give two that the same runs have"
    if not own[name]:
        return f"{said}: give {catalogue.RESULT}{name}, as the catalogue calls this number"
    along = [other for other, dims in own.items() if dims == own[name] and other != name]
    return (
        f"{said}: {name} is no single number of a run but runs over {', '.join(own[name])}; "
        f"compare it with what runs alike, as {_listed(along)}, or give one number a run in its "
        f"place, as {_listed(figures)}"
    )


def _given(
    table: pd.DataFrame,
    variable: str,
    over: str | None,
    own: dict[str, tuple[str, ...]],
    figures: Sequence[str],
) -> str:
    """What there is to give: headline figures with what differs, or variables."""
    if not variable.startswith(catalogue.RESULT):
        return f"give what they have, as {_listed(own)}"
    if variable not in table.columns or over is None:
        return f"give what they have, as {_listed(figures)}"
    keys = [key for key in catalogue.independent(table) if key not in figures]
    return f"give over=KEY, what differs, as {_listed(keys)}"


def _listed(names: Sequence[str] | dict[str, tuple[str, ...]]) -> str:
    return ", ".join(sorted(names)) or "(none)"
