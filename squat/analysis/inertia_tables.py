"""Tables 4 to 6: added mass."""

import json
import math

import numpy as np
import xarray as xr

from squat import published
from squat.analysis.lookup import MISSING, Here, LookUp
from squat.analysis.verdict import MATCH, half_digit, judge

MESH = "here_paper_mesh"
"""Column of values on our guess of the paper's mesh, which it does not state."""
PRINTED = {
    (float(keys["depth_over_draft"]), float(keys["a_over_T"]))
    for keys, _ in published.table("table5")
}
"""H/T and a/T of the cells of Table 5."""
OTHER_READING = "1.5"
"""Row of Table 5 that fits T = 10 m fixed in all its cells, and no other reading."""


def select(data: xr.Dataset, reading: str, ratio: float, a_over_T: float) -> xr.Dataset | None:
    """One cell of an `inertia` dataset, or None."""
    found = (
        (data["reading"] == reading)
        & (data["depth_over_draft"] == ratio)
        & (data["a_over_T"] == a_over_T)
    ).values
    return data.isel(cell=int(np.argmax(found))) if found.any() else None


def _value(cell: xr.Dataset) -> float:
    return float(cell["inertia_coefficient"])


def table4(data: xr.Dataset) -> LookUp:
    """Inertia coefficient at a/T = 1, Wendel's and the paper's."""

    def here(keys: dict[str, str]) -> Here:
        ratio = float(keys["depth_over_draft"])
        cell = select(data, "deep" if math.isinf(ratio) else "depth", ratio, 1.0)
        if cell is None:
            return MISSING
        note = "H/T = 10, 20, 40 extrapolated in 1/H^2" if math.isinf(ratio) else ""
        columns = _own_columns(cell)
        if keys["source"] == "wendel_1956":
            note = "; ".join(filter(None, ["Wendel's values are estimates", note]))
            del columns[MESH]
        return Here(_value(cell), note, explained=keys["source"] == "wendel_1956", columns=columns)

    return here


def table5(data: xr.Dataset) -> LookUp:
    """Inertia coefficient over H/T and a/T, in the main reading and with T = 10 m fixed."""

    def here(keys: dict[str, str]) -> Here:
        place = float(keys["depth_over_draft"]), float(keys["a_over_T"])
        main, other = select(data, "depth", *place), select(data, "draft", *place)
        if main is None or other is None:
            return MISSING
        chosen, note = main, ""
        if keys["a_over_T"] == OTHER_READING:
            chosen, note = other, "T = 10 m fixed: this row fits no other reading"
        return Here(_value(chosen), note, columns=_columns(main, other, chosen))

    return here


def _columns(main: xr.Dataset, other: xr.Dataset, chosen: xr.Dataset) -> dict[str, str]:
    return {
        **_own_columns(chosen),
        "here_T10": f"{_value(other):.12g}",
        "error_T10": f"{float(other['inertia_coefficient_error']):.2g}",
        "here_H20": f"{_value(main):.12g}",
    }


def _own_columns(cell: xr.Dataset) -> dict[str, str]:
    return {
        "error": f"{float(cell['inertia_coefficient_error']):.2g}",
        MESH: f"{float(cell['inertia_coefficient_mesh']):.12g}",
    }


def bounded_away(printed: str, cell: dict[str, str]) -> bool:
    """Whether the print exceeds the exact value in both readings: elements can only be lower."""
    exact = max(
        float(cell["here_H20"]) + float(cell["error"]),
        float(cell["here_T10"]) + float(cell["error_T10"]),
    )
    return float(printed) - half_digit(printed) > exact


def with_mesh(printed: str, here: Here) -> Here:
    """`here` with the verdict on the paper's mesh, and `inconsistent` where a bound says so."""
    if MESH not in here.columns:
        return here
    columns = dict(here.columns)
    mesh = float(columns[MESH])
    columns["verdict_paper_mesh"] = judge(printed, mesh)
    proven = "error_T10" in columns and bounded_away(printed, columns)
    if proven:
        note = "above the exact value in every reading, which finite elements approach from below"
    else:
        note = "; ".join(filter(None, [here.note, _by_mesh(printed, mesh)]))
    by_mesh = MATCH in (judge(printed, mesh), judge(printed, mesh, rounds_down=True))
    return here._replace(columns=columns, inconsistent=proven, explained=by_mesh, note=note)


def _by_mesh(printed: str, mesh: float) -> str:
    """What our guess of the paper's mesh has to do with the print."""
    guess = "our guess of the paper's mesh"
    if judge(printed, mesh) == MATCH:
        return f"{guess} lies lower and gives what is printed: {mesh:.4f}"
    if judge(printed, mesh, rounds_down=True) == MATCH:
        return f"{guess} lies lower and gives what is printed, cut off: {mesh:.4f}"
    if abs(float(printed) - mesh) > 3 * half_digit(printed):
        return f"{guess} gives {mesh:.4f}, and no reading tried fits: a misprint?"
    return f"{guess} gives {mesh:.4f}"


def table5_critical(data: xr.Dataset) -> LookUp:
    """2/(pi a/T): below it the added mass is less than the ship's."""

    def here(keys: dict[str, str]) -> Here:
        a = float(keys["a_over_T"])
        row = data.isel(cell=np.flatnonzero((data["a_over_T"] == a) & (data["reading"] == "depth")))
        if row.sizes["cell"] == 0:
            return MISSING
        limit = 2 / (math.pi * a)
        met = row["depth_over_draft"].values[row["inertia_coefficient"].values <= limit]
        where = f"from H/T = {met.min():g} on" if met.size else "nowhere"
        printed = {ratio for ratio, length in PRINTED if length == a}
        missing = len(printed - set(row["depth_over_draft"].values.tolist()))
        unknown = f"; {missing} of its printed cells were not run" if missing else ""
        return Here(limit, f"m_add <= m {where} in this row{unknown}", columns={"met": where})

    return here


def table6(data: xr.Dataset) -> LookUp:
    """Geometry, inertia coefficient, mass ratio and mesh of section 3.6."""
    config = json.loads(data.attrs["config"])
    hull, channel = config["hull"], config["channel"]
    value = {
        "H": channel["depth"],
        "H_over_T": channel["depth"] / hull["draft"],
        "L_over_T": hull["length"] / hull["draft"],
        "inlet_distance_over_L": channel["upstream"] / hull["length"],
        "outlet_distance_over_L": channel["downstream"] / hull["length"],
        "inertia_coefficient": float(data["inertia_coefficient"]),
        "madd_over_m": float(data["mass_ratio"]),
        "mesh_nodes": data.sizes["node"],
        "mesh_triangles": data.sizes["face"],
    }
    coarse = (
        "exact in the printed geometry; a mesh of 2 m throughout, or In and Out nearer, gives it"
    )
    euler = "triangles = 2 nodes - 2 - boundary nodes: the printed pair leaves no boundary"
    notes = {
        "inertia_coefficient": coarse,
        "madd_over_m": coarse,
        "mesh_nodes": "0.1 m at the hull, slope 0.35 to 2 m",
        "mesh_triangles": euler,
    }

    def here(keys: dict[str, str]) -> Here:
        name = keys["quantity"]
        if name not in value:
            return MISSING
        return Here(
            value[name], notes.get(name, ""), inconsistent=name == "mesh_triangles", explained=True
        )

    return here
