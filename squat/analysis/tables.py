"""The paper's tables, one row a printed cell."""

import json
import math
from collections.abc import Callable
from pathlib import Path
from typing import Any, Literal, NamedTuple

import pandas as pd
import xarray as xr
from pydantic.dataclasses import dataclass

from squat import published, records
from squat.analysis.pages import write_frame
from squat.analysis.verdict import DIFFERS, INCONSISTENT, Verdict, difference, judge
from squat.errors import InputError
from squat.quantities import STRICT
from squat.records.kinds import EQUILIBRIA, ITERATIONS
from squat.records.schema import Kind


@dataclass(frozen=True, kw_only=True, config=STRICT)
class TableCase:
    """Which table, from which dataset.

    Parameters
    ----------
    number
        Number of the table in the paper.
    data
        Path of the dataset that holds our values.
    """

    number: Literal[1, 2, 3, 7]
    data: str


class Here(NamedTuple):
    """Our value of a cell."""

    value: float
    note: str = ""
    rounds_down: bool = False
    inconsistent: bool = False


def _table1(data: xr.Dataset) -> Callable[[dict[str, str]], Here]:
    config = json.loads(data.attrs["config"])
    value = {
        "L": config["piston"]["length"],
        "S": config["piston"]["area"],
        "rho": config["water"]["density"],
        "w0": config["piston"]["initial_position"],
        "wdot0": config["piston"]["initial_velocity"],
        "steps_per_period": config["time"]["steps_per_period"],
        "periods": config["time"]["periods"],
    }
    return lambda keys: Here(value[keys["quantity"]])


def _table2(data: xr.Dataset) -> Callable[[dict[str, str]], Here]:
    ratio = {"standard": 0.0, "corrected": 1.0}
    excluded = unreachable(data)

    def here(keys: dict[str, str]) -> Here:
        value = _cell(data, ratio[keys["scheme"]], float(keys["mf_over_m"]))
        if keys["scheme"] == "standard" and keys["mf_over_m"] in excluded:
            low, high = excluded[keys["mf_over_m"]]
            note = f"Eq. (11) gives the printed count only at tolerances {low:.1e} to {high:.1e} m"
            return Here(value, note, rounds_down=True, inconsistent=True)
        return Here(value, "does not converge" if value == float("inf") else "", rounds_down=True)

    return here


def _table3(data: xr.Dataset) -> Callable[[dict[str, str]], Here]:
    return lambda keys: Here(
        _cell(data, float(keys["madd_over_mf"]), float(keys["mf_over_m"])), rounds_down=True
    )


def _table7(data: xr.Dataset) -> Callable[[dict[str, str]], Here]:
    def here(keys: dict[str, str]) -> Here:
        column = data[f"case_{keys['root']}"].values
        found = column[data["case_speed"].values == float(keys["V_inf"])]
        return Here(float(found[0]) if found.size else float("nan"))

    return here


def _cell(data: xr.Dataset, added_mass_ratio: float, mass_ratio: float) -> float:
    """Mean iterations of one cell; NaN where the study left it out."""
    table = data["mean_iterations"]
    present = (
        added_mass_ratio in table["added_mass_ratio"].values
        and mass_ratio in table["mass_ratio"].values
    )
    if not present:
        return float("nan")
    return float(table.sel(added_mass_ratio=added_mass_ratio, mass_ratio=mass_ratio))


Interval = tuple[float, float]


def implied_tolerance(
    printed: float, here: float, factor: float, tolerance: float, slack: float = 1.0
) -> Interval:
    """Tolerances at which Eq. (11) would give the `printed` mean count, give or take `slack`.

    The residual falls by |G| = `factor` an iteration, whatever the starting error, so that the
    mean count N at another tolerance is `here` + ln(other/tolerance)/ln|G|.
    """
    return (
        tolerance * factor ** (printed + 1 + slack - here),
        tolerance * factor ** (printed - slack - here),
    )


def unreachable(data: xr.Dataset) -> dict[str, Interval]:
    """Standard cells of Table 2 that no tolerance shared with the rest can give (proof: tests).

    Maps the printed m_f/m to the tolerances [m] that the cell would need.
    """
    tolerance = float(json.loads(data.attrs["config"])["criterion"]["tolerance"])
    needed: dict[str, Interval] = {}
    for keys, text in published.table(2):
        ratio = float(keys["mf_over_m"])
        here = _cell(data, 0.0, ratio)
        if keys["scheme"] == "standard" and text not in ("", "inf") and abs(here) < float("inf"):
            cell = data["predicted_contraction"].sel(added_mass_ratio=0.0, mass_ratio=ratio)
            factor = abs(float(cell))
            needed[keys["mf_over_m"]] = implied_tolerance(float(text), here, factor, tolerance)
    shared = [span for span in needed.values() if span[0] <= tolerance <= span[1]]
    low = max((span[0] for span in shared), default=tolerance)
    high = min((span[1] for span in shared), default=tolerance)
    return {key: span for key, span in needed.items() if span[1] < low or span[0] > high}


_SOURCES: dict[int, tuple[Kind, Callable[[xr.Dataset], Callable[[dict[str, str]], Here]]]] = {
    1: (ITERATIONS, _table1),
    2: (ITERATIONS, _table2),
    3: (ITERATIONS, _table3),
    7: (EQUILIBRIA, _table7),
}


def compare(number: int, data: xr.Dataset) -> pd.DataFrame:
    """Table `number`: keys, paper, here, difference, verdict, note; cells not run are left out."""
    look_up = _SOURCES[number][1](data)
    rows: list[dict[str, Any]] = []
    for keys, text in published.table(number):
        here = look_up(keys)
        if math.isnan(here.value):
            continue
        verdict: Verdict = judge(text, here.value, rounds_down=here.rounds_down)
        if verdict == DIFFERS and here.inconsistent:
            verdict = INCONSISTENT
        apart = difference(text, here.value)
        ours = {
            "here": f"{here.value:.12g}",
            "difference": "" if math.isnan(apart) else f"{apart:.6g}",
        }
        rows.append({**keys, "paper": text, **ours, "verdict": verdict, "note": here.note})
    return pd.DataFrame(rows)


def write_table(case: TableCase, path: Path) -> None:
    """Write Table `case.number` as CSV."""
    kind = _SOURCES[case.number][0]
    frame = compare(case.number, records.read(Path(case.data), kind))
    if frame.empty:
        raise InputError(f"data={case.data}: holds no cell of Table {case.number}; use cells=paper")
    write_frame(frame, path)
