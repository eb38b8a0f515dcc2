"""Tables 4 to 6: verdicts, and the proofs behind `paper inconsistent`."""

import math

import numpy as np
import pytest

from squat.analysis.tables import compare
from squat.config import compose, validate
from squat.fluid.inertia import finite_cells
from squat.fluid.matching import RectangleReference, rigid_modes
from squat.published import table

HEAVE = {"heave": rigid_modes(0.0, 0.0)["heave"]}


def exact(ratio, a_over_T, depth, distance, **options):
    draft = depth / ratio
    length = 2 * a_over_T * draft
    case = RectangleReference(length, draft, depth, distance, distance, "zero_pressure", **options)
    return case.added_mass(HEAVE)[0, 0] / (np.pi * (length / 2) ** 2)


def test_table_4_and_5_hold_a_tenth_of_a_percent(sources):
    for data in (sources.table4, sources.table5):
        relative = data["inertia_coefficient_error"] / data["inertia_coefficient"]
        assert float(relative.max()) < 1e-3


def test_tables_4_and_5_are_whole_and_named_as_promised():
    """12 and 63 cells; the composed cases run each of them, whatever its value."""
    assert len(table("table4")) == 12
    assert len(table("table5")) == 63
    cells = validate(compose("inertia")).case.cells
    run = {(one.depth_over_draft, one.a_over_T) for one in finite_cells(cells)}
    printed = [(cell.keys["depth_over_draft"], cell.keys["a_over_T"]) for cell in table("table5")]
    assert {(float(ratio), float(a)) for ratio, a in printed} == run
    cells = validate(compose("inertia", "cases/inertia@cells=table4")).case.cells
    run = {one.depth_over_draft for one in finite_cells(cells)} | {math.inf}
    assert {float(cell.keys["depth_over_draft"]) for cell in table("table4")} == run


def test_table_5_has_the_promised_columns(sources):
    names = "depth_over_draft a_over_T paper here error here_paper_mesh verdict_paper_mesh"
    more = "here_T10 error_T10 difference verdict note"
    assert {*names.split(), *more.split()} <= set(compare("table5", sources.table5).columns)


def test_table_5_values_are_those_of_the_independent_method(sources):
    for reading, depth in (("depth", lambda ratio: 20.0), ("draft", lambda ratio: 10 * ratio)):
        cells = sources.table5.isel(cell=np.flatnonzero(sources.table5["reading"] == reading))
        for i in range(cells.sizes["cell"]):
            cell = cells.isel(cell=i)
            ratio, a = float(cell["depth_over_draft"]), float(cell["a_over_T"])
            value = exact(ratio, a, depth(ratio), 50.0, terms=40_000, functions=24)
            error = float(cell["inertia_coefficient_error"])
            assert abs(float(cell["inertia_coefficient"]) - value) < error + 1e-7 * value


def test_the_cell_printed_above_every_reading_is_inconsistent(sources):
    """a/T = 0.5, H/T = 6: finite elements approach the exact value from below, in any channel."""
    printed = next(
        cell.text
        for cell in table("table5")
        if cell.keys == {"a_over_T": "0.5", "depth_over_draft": "6"}
    )
    readings = [exact(6.0, 0.5, 20.0, distance) for distance in (20 / 6, 50.0, 2000.0)]
    readings += [exact(6.0, 0.5, 60.0, distance) for distance in (50.0, 2000.0)]
    assert max(readings) < float(printed) - 0.005
    row = compare("table5", sources.table5).query("a_over_T == '0.5' and depth_over_draft == '6'")
    assert list(row["verdict"]) == ["paper inconsistent"]


def test_cells_of_the_paper_that_differ_say_what_its_mesh_gives(sources):
    """P1 elements approach from below: cut off, a value on them is the print where ours is not."""
    rows = compare("table4", sources.table4).query("source == 'paper' and verdict == 'differs'")
    assert len(rows) == 2
    cut = rows["note"].str.contains("gives what is printed, cut off: 1.9392", regex=False)
    whole = rows["note"].str.contains("gives what is printed: 0.7501", regex=False)
    assert (cut | whole).all()
    wendel = compare("table4", sources.table4).query("source == 'wendel_1956'")
    assert not wendel["note"].str.contains("mesh").any()


def test_row_a_over_T_of_1_5_is_judged_by_its_own_reading(sources):
    rows = compare("table5", sources.table5).query("a_over_T == '1.5'")
    assert (rows["here"] == rows["here_T10"]).all()
    assert (rows["verdict"] == "match").all()
    assert rows["note"].str.contains("T = 10 m fixed").all()


def test_the_printed_mesh_contradicts_eulers_formula(sources):
    """A triangulated disc has 2 n - 2 - b triangles, b nodes on its boundary; ours obeys it."""
    count = {cell.keys["quantity"]: cell.text for cell in table("table6")}
    nodes, triangles = int(count["mesh_nodes"]), int(count["mesh_triangles"])
    assert 2 * nodes - 2 - triangles <= 0
    data = sources.table6
    boundary = 2 * data.sizes["node"] - 2 - data.sizes["face"]
    faces = data["face_node"].values
    sides = np.sort(faces[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2), axis=1)
    _, times = np.unique(sides, axis=0, return_counts=True)
    assert boundary == np.count_nonzero(times == 1)
    verdicts = compare("table6", data).set_index("quantity")["verdict"]
    assert verdicts["mesh_triangles"] == "paper inconsistent"


def test_table_5_itself_contradicts_that_added_mass_always_exceeds_the_ships_mass():
    light = [
        cell
        for cell in table("table5")
        if float(cell.text) * math.pi * float(cell.keys["a_over_T"]) / 2 < 1
    ]
    assert len(light) > 0
    assert {cell.keys["a_over_T"] for cell in light} == {"0.5"}


def test_deep_water_is_extrapolated_to_schwarz_and_christoffels_value(sources):
    from squat.fluid.deep_water import heave_inertia_coefficient

    deep = sources.table4.isel(cell=np.flatnonzero(sources.table4["reading"] == "deep"))
    error = float(deep["inertia_coefficient_error"][0])
    value = float(deep["inertia_coefficient"][0])
    assert abs(value - heave_inertia_coefficient(1.0)) < error


def test_table_6_is_larger_than_printed_because_the_printed_geometry_is(sources):
    assert float(sources.table6["inertia_coefficient"]) == pytest.approx(
        exact(2.0, 2.0, 20.0, 40.0, terms=40_000) * 1.0, rel=2e-3
    )
    assert float(sources.table6["mass_ratio"]) == pytest.approx(
        float(sources.table6["inertia_coefficient"]) * math.pi, rel=1e-12
    )
