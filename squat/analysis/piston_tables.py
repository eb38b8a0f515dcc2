"""Tables 1 to 3: the piston."""

import json

import xarray as xr

from squat import published
from squat.analysis.lookup import Here, LookUp


def table1(data: xr.Dataset) -> LookUp:
    """Parameters of the run."""
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


_ODD = ("10", "0.8")
"""m_add/m_f and m_f/m of the one cell of Table 3 that is off by more than its rounding."""
CUT_OFF = {"0.66": 0.666}
"""Printed m_f/m that may be the cut-off of another number, as the counts are."""


def table2(data: xr.Dataset) -> LookUp:
    """Iterations against mass ratio, standard and corrected."""
    ratio = {"standard": 0.0, "corrected": 1.0}
    excluded = unreachable(data)

    def here(keys: dict[str, str]) -> Here:
        found = _count(data, ratio[keys["scheme"]], keys["mf_over_m"])
        if keys["scheme"] == "standard" and keys["mf_over_m"] in excluded:
            low, high = excluded[keys["mf_over_m"]]
            note = "Eq. (11) gives the printed count, give or take one, only at tolerances "
            note += f"{low:.1e} to {high:.1e} m"
            return found._replace(note=note, inconsistent=True)
        return found

    return here


def table3(data: xr.Dataset) -> LookUp:
    """Iterations against mass ratio and added mass."""

    def here(keys: dict[str, str]) -> Here:
        found = _count(data, float(keys["madd_over_mf"]), keys["mf_over_m"])
        odd = (keys["madd_over_mf"], keys["mf_over_m"]) == _ODD
        return found._replace(note="no reading tried gives it") if odd else found

    return here


def _count(data: xr.Dataset, added_mass_ratio: float, printed_ratio: str) -> Here:
    """Mean iterations of one cell, which the paper rounds down."""
    value = _cell(data, added_mass_ratio, float(printed_ratio))
    note = "does not converge" if value == float("inf") else ""
    if printed_ratio in CUT_OFF:
        meant = _cell(data, added_mass_ratio, CUT_OFF[printed_ratio])
        note = f"m_f/m = {CUT_OFF[printed_ratio]}, cut off to {printed_ratio}, gives {meant:.5g}"
    return Here(value, note, rounds_down=True, explained=printed_ratio in CUT_OFF)


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
    for keys, text in published.table("table2"):
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
