"""Table 7: the roots of Eq. (27)."""

import xarray as xr

from squat.analysis.lookup import Here, LookUp

_NOTES = {
    ("1", "unstable"): "the force of (27), its lost denominator as read here, vanishes nowhere "
    "within half a printed digit"
}


def table7(data: xr.Dataset) -> LookUp:
    """Both roots inside the channel, by speed."""

    def here(keys: dict[str, str]) -> Here:
        column = data[f"case_{keys['root']}"].values
        found = column[data["case_speed"].values == float(keys["V_inf"])]
        note = _NOTES.get((keys["V_inf"], keys["root"]), "")
        return Here(float(found[0]) if found.size else float("nan"), note)

    return here
