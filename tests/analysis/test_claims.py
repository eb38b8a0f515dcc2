"""Checks of the paper's sentences, on small invented datasets whose answers are plain."""

import json
import math
import re

import numpy as np
import pandas as pd
import pytest
import xarray as xr

from squat import published, records
from squat.analysis import TableCase, piston_tables, verdicts, write_table
from squat.analysis.claims import CHECKS, Sources
from squat.analysis.inertia_tables import _by_mesh, bounded_away, table5_critical
from squat.analysis.lookup import Here
from squat.analysis.tables import _coarse, _rounding
from squat.analysis.transient_claims import period
from squat.analysis.verdicts import COLUMNS, VerdictsCase, _found, table_rows, write_verdicts
from squat.errors import InputError
from squat.stability.run import run as equilibria

WENDEL = [cell for cell in published.table("table4") if cell.keys["source"] == "wendel_1956"]
ERRORS = ("error", "mesh")
NOTHING = Sources(*[None] * 7, transients=(), pitching=())


def inertia(*cells):
    """Rows of reading, H/T, a/T, i."""
    names = "reading", "depth_over_draft", "a_over_T", "inertia_coefficient"
    columns = zip(names, zip(*cells, strict=True), strict=True)
    return xr.Dataset({name: ("cell", list(values)) for name, values in columns})


def coupled(current, status="completed", **data):
    scheme = {"integrator": "centred", "potential_rate": "centred"}
    config = {"coupling": {**scheme, "criterion": {"iterations": 200}}}
    attrs = {"coupling": "printed", "current": current, "status": status}
    return xr.Dataset(data, attrs=attrs | {"config": json.dumps(config)})


def finding(claim, **sources):
    return CHECKS[claim](NOTHING._replace(**sources))


@pytest.mark.parametrize(
    ("highest", "verdict"),
    [((1.25, 5.0), "match"), ((1.25, 1.0), "differs"), ((4.0, 5.0), "differs")],
)
def test_highest_coefficient_is_sought_at_the_corner_of_the_table(highest, verdict):
    cells = [
        ("depth", h, a, 9.0 if (h, a) == highest else 1.0) for h in (1.25, 4.0) for a in (1.0, 5.0)
    ]
    assert finding("highest", table5=inertia(*cells)).verdict == verdict
    narrow = inertia(*(cell for cell in cells if cell[2] == 1.0))
    assert finding("highest", table5=narrow).verdict == "not run"


def test_lighter_water_than_ship_is_counted_by_the_critical_coefficient():
    """i = 2/(pi a/T) is an added mass as large as the ship's."""
    cells = [
        ("depth", h, 2.0, share / math.pi) for h, share in ((1.25, 1.01), (2.0, 0.99), (4.0, 0.98))
    ]
    table = inertia(*cells, ("draft", 6.0, 2.0, 0.1), ("depth", 1.1, 9.0, 0.001))
    found = table5_critical(table)({"a_over_T": "2"})
    assert found.value == pytest.approx(1 / math.pi)
    assert found.columns["met"] == "from H/T = 2 on"
    printed = {float(cell.keys["depth_over_draft"]) for cell in published.table("table5")}
    missing = len(printed - {1.25, 2.0, 4.0})
    assert missing > 0
    note = "m_add <= m from H/T = 2 on in this row"
    assert found.note == f"{note}; {missing} of its printed cells were not run"
    whole = inertia(*(("depth", ratio, 2.0, 0.1) for ratio in printed))
    assert table5_critical(whole)({"a_over_T": "2"}).note.endswith("in this row")
    assert math.isnan(table5_critical(table)({"a_over_T": "3"}).value)


def test_only_printed_cells_of_table_5_are_counted():
    printed = [
        (float(cell.keys["depth_over_draft"]), float(cell.keys["a_over_T"]))
        for cell in published.table("table5")
    ]
    for light, rarely, always in (
        (0, "match", "differs"),
        (12, "match", "paper inconsistent"),
        (13, "differs", "paper inconsistent"),
    ):
        cells = [
            ("depth", h, a, (0.9 if n < light else 1.1) * 2 / (math.pi * a))
            for n, (h, a) in enumerate(printed)
        ]
        more = [("depth", 8.0, 0.5, 0.1), ("draft", *printed[-1], 0.1)]
        for missing in (0, 1):
            table = inertia(*cells[: len(cells) - missing], *more)
            rare = finding("rarely_satisfied", table5=table)
            assert f"{light} of {63 - missing} cells" in str(rare.here)
            assert rare.verdict == ("not run" if missing else rarely)
            unless = "not run" if missing and not light else always
            assert finding("exceeds_mass", table5=table).verdict == unless


@pytest.mark.parametrize("name", ["new_freedoms", "refreshed_matrix", "pressure_ends"])
def test_a_sentence_whose_cases_are_not_there_is_not_run(name):
    assert _found(CHECKS[name], NOTHING).verdict == "not run"


def test_the_last_cell_lost_is_named():
    status = np.array([["converged"] * 2, ["diverged", "converged"], ["converged", "diverged"]])
    cells = xr.Dataset(
        {"status": (("added_mass_ratio", "mass_ratio"), status)},
        {"added_mass_ratio": [0.0, 0.1, 0.2], "mass_ratio": [3.0, 7.0]},
    )
    found = finding("unconditional", iterations=cells)
    assert found.here == "diverges at m_add/m_f = 0.2, m_f/m = 7"
    assert found.verdict == "paper inconsistent"


@pytest.mark.parametrize(
    ("half", "double", "verdict"), [([9.0], [8.0], "match"), ([8.0], [9.0], "paper inconsistent")]
)
def test_what_overestimating_costs_is_held_against_the_printed_table_too(half, double, verdict):
    means = (("added_mass_ratio", "mass_ratio"), [half, double])
    cells = {"added_mass_ratio": [0.5, 2.0], "mass_ratio": [0.2]}
    found = finding("overestimate", iterations=xr.Dataset({"mean_iterations": means}, cells))
    assert found.verdict == verdict
    assert ("at m_f/m = 0.2, 0.5, 0.66" in found.note) == (verdict != "match")


@pytest.mark.parametrize(("order", "verdict"), [(1.98, "match"), (0.97, "paper inconsistent")])
def test_second_order_of_centred_differences_contradicts_the_printed_scheme(order, verdict):
    orders = xr.Dataset({"observed_order": ("integrator", [order])}, {"integrator": ["centred"]})
    assert finding("centred_order", iterations=orders).verdict == verdict


@pytest.mark.parametrize(("added", "mass"), [("0.5", "9"), ("9", "2"), ("9", "9")])
def test_a_cell_that_a_study_left_out_is_missing(added, mass):
    counts = xr.DataArray([[4.0]], {"added_mass_ratio": [0.5], "mass_ratio": [2.0]}).rename("x")
    look = piston_tables.table3(xr.Dataset({"mean_iterations": counts}))
    assert look({"madd_over_mf": "0.5", "mf_over_m": "2"}).value == 4.0
    assert math.isnan(look({"madd_over_mf": added, "mf_over_m": mass}).value)


def test_a_value_is_rounded_and_the_print_believed_unless_said_otherwise():
    assert Here(1.0) == Here(1.0, "", rounds_down=False, inconsistent=False)


def test_inertia_fed_back_is_that_of_the_slowest_run_at_its_start():
    slow = coupled(1.0, fluid_inertia=("time", [12.0, 40.0]), ship_mass=1.0, added_mass=3.0)
    fast = coupled(2.0, fluid_inertia=("time", [90.0, 91.0]), ship_mass=1.0, added_mass=7.0)
    said = str(finding("operator_inertia", transients=(fast, slow)))
    assert "(19) has 12, (23) 3; the centred reading feeds back 0.25 of the former, 3" in said


@pytest.mark.parametrize(("saved", "verdict"), [((2.0, 4.0), "match"), ((2.0, 6.0), "differs")])
def test_efficiency_is_in_proportion_where_twice_the_density_saves_twice_as_much(saved, verdict):
    cells = xr.Dataset(
        {
            "density_mean_iterations": (
                ("density_added_mass_ratio", "density"),
                [[5.0 * factor for factor in saved], [5.0, 5.0]],
            )
        },
        {"density_added_mass_ratio": [0.0, 1.0], "density": [500.0, 1000.0]},
    )
    assert finding("density", iterations=cells).verdict == verdict


@pytest.mark.parametrize(
    ("printed", "here", "note"),
    [
        ("0.63", Here(0.6366), "printed cut off, where other cells are rounded"),
        ("12", Here(11.81, rounds_down=True), "printed rounded, where other cells are cut off"),
        ("49", Here(48.4, rounds_down=True), ""),
    ],
)
def test_a_print_that_is_ours_cut_off_or_rounded_is_told(printed, here, note):
    assert _rounding(printed, here) == note


def beside_wendel(share):
    """A Table 4 whose cells of finite depth are that `share` of Wendel's."""
    printed = {key["depth_over_draft"]: float(text) for key, text in WENDEL}
    cells = [("depth", float(h), 1.0, value * share) for h, value in printed.items() if h != "inf"]
    rows = inertia(*cells, ("deep", np.inf, 1.0, 0.76))
    errors = {f"inertia_coefficient_{name}": 0 * rows["inertia_coefficient"] for name in ERRORS}
    return rows.assign(errors)


def test_how_far_below_wendel_we_are_is_told_with_the_cells():
    found = finding("underestimates", table4=beside_wendel(0.98))
    assert found.here == "below Wendel's in 5 of 5 cells of finite depth, by 2.0% to 2.0%"
    assert found.verdict == "match"


@pytest.mark.parametrize(
    ("share", "verdict"), [(0.98, "match"), (1.02, "match"), (0.96, "differs")]
)
def test_very_good_agreement_is_within_three_percent_of_wendels(share, verdict):
    found = finding("very_good_agreement", table4=beside_wendel(share))
    assert found.verdict == verdict
    assert f"{100 * abs(share - 1):.1f} % of Wendel's" in str(found.here)


@pytest.mark.parametrize(
    ("ratio", "verdict"), [(0.99, "differs"), (1.0, "differs"), (1.01, "match")]
)
def test_a_period_is_longer_where_it_exceeds_the_linear_one(ratio, verdict):
    time = np.linspace(0, 20, 401)
    run = coupled(1.0, time=("time", time), heave=("time", np.cos(time)))
    linear = period(run) / ratio
    run = run.assign(omega=2 * np.pi / linear, fluid_inertia=("time", 0 * time), ship_mass=1.0)
    assert 2 * np.pi / float(run["omega"]) == linear
    assert finding("longer_period", transients=(run,)).verdict == verdict


def test_the_list_has_the_cells_of_all_tables_and_the_sentences(tmp_path, monkeypatch):
    monkeypatch.setattr(verdicts.records, "read", lambda *_: None)
    for name in ("table_rows", "claim_rows"):
        monkeypatch.setattr(
            verdicts, name, lambda source, name=name: [dict.fromkeys(COLUMNS, name)]
        )
    sources = dict.fromkeys(VerdictsCase.__dataclass_fields__, "x")
    sources |= dict.fromkeys(("tables", "transients", "pitching"), ("x", "x"))
    write_verdicts(VerdictsCase(**sources), tmp_path / "verdicts.csv")
    listed = pd.read_csv(tmp_path / "verdicts.csv")["claim"]
    assert list(listed) == ["table_rows", "table_rows", "claim_rows"]


@pytest.mark.parametrize(("here", "proven"), [(0.86, True), (0.8645, False), (0.87, False)])
@pytest.mark.parametrize("other", [0, 1])
def test_a_print_is_bounded_away_by_the_greater_of_both_readings_with_its_error(
    here, proven, other
):
    values = [here, 0.8]
    H20, T10 = values[other], values[1 - other]
    cell = {"here_H20": f"{H20}", "here_T10": f"{T10}", "error": "1e-3", "error_T10": "1e-3"}
    assert bounded_away("0.87", cell) == proven


@pytest.mark.parametrize(("counts", "verdict"), [([0, 9], "match"), ([0, 8, 8], "differs")])
def test_an_order_has_an_impact_where_it_costs_more_than_eight_iterations(counts, verdict):
    run = coupled(1.0, iterations=("time", counts))
    assert finding("precision_order", transients=(run,)).verdict == verdict


def test_a_match_by_few_digits_says_so():
    assert _coarse("1", Here(0.8), 0.2) == "a match by the few digits printed, 25% of ours apart"
    assert _coarse("0.81", Here(0.8), -0.01) == ""
    assert _coarse("1", Here(1.4, rounds_down=True), 0.4) == ""
    assert _coarse("", Here(math.inf), math.nan) == ""


@pytest.mark.parametrize(
    ("printed", "mesh", "note"),
    [
        (
            "1.23",
            1.2312,
            "our guess of the paper's mesh lies lower and gives what is printed: 1.2312",
        ),
        (
            "0.95",
            0.9942,
            "our guess of the paper's mesh gives 0.9942, and no reading tried fits: a misprint?",
        ),
        (
            "0.86",
            0.8651,
            "our guess of the paper's mesh lies lower and gives what is printed, cut off: 0.8651",
        ),
        ("0.86", 0.8712, "our guess of the paper's mesh gives 0.8712"),
    ],
)
def test_a_cell_says_what_the_mesh_of_the_paper_gives(printed, mesh, note):
    assert _by_mesh(printed, mesh) == note


def test_pressure_of_the_ends_is_the_mean_over_the_length_of_the_outer_tenths():
    x = 20.0 - 20.0 * np.cos(np.linspace(0, np.pi, 401))  # nodes crowd at the ends
    pressure = -100 * abs(x - 20)  # -1800 in the mean from 16 to 20 m off the middle, -500 to 10 m
    run = coupled(
        1.0,
        hull_x=("hull_node", x),
        hull_z=("hull_node", np.zeros(401)),
        hull_pressure=(("time", "hull_node"), [np.zeros(401), pressure]),
    )
    found = finding("pressure_ends", transients=(run,))
    told = re.match(r"lower by (\d+) Pa", str(found.here))
    assert float(told.group(1)) == pytest.approx(1300, rel=5e-4)  # whole Pa
    assert found.verdict == "match"


@pytest.mark.parametrize(
    ("fates", "verdict", "note"),
    [
        ({1: True, 2: True, 2.25: True, 2.5: False}, "match", ""),
        ({1: True, 2: True, 2.25: True, 2.4: True, 2.5: False}, "match", ""),
        ({1: True, 2: True, 2.25: False, 2.5: False}, "differs", ""),
        ({1: True, 2: True, 2.3: True, 2.5: False}, "not run", "not run: 2.25 m/s"),
        ({1: True, 2: False, 2.5: False}, "differs", "not run: 2.25 m/s"),
    ],
)
def test_fates_are_those_at_the_currents_of_the_sentence(fates, verdict, note):
    runs = (coupled(v, "completed" if stable else "grounded") for v, stable in fates.items())
    found = finding("stable_speeds", transients=tuple(runs))
    assert (found.verdict, found.note) == (verdict, note)


@pytest.mark.parametrize("status", ["diverged", "iteration limit"])
def test_where_the_corrected_scheme_stops_is_told_with_the_factor_of_the_failed_step(status):
    run = coupled(2.5, status, heave=("time", [0.0, -5.0]), failed_contraction=-0.957)
    found = finding("corrected_converges", transients=(run,))
    assert found.verdict == "differs"
    assert "below w = -5.000 m" in str(found.here)
    assert "the next step has G = -0.957" in found.note
    assert ("meets the limit of 200 iterations" in found.note) == (status == "iteration limit")


def test_iterations_that_run_away_grow_faster_than_exponentially():
    """1/(1 - |G|) with G falling to -1 does; equal factors in equal times are exponential."""
    steps = np.arange(1.0, 81.0)
    for count, verdict in ((200 / (81 - steps), "differs"), (2 ** (steps / 20), "match")):
        run = coupled(2.5, "iteration limit", iterations=("time", np.r_[0, count]))
        assert finding("iterations_grow", transients=(run,)).verdict == verdict


@pytest.mark.parametrize(("safe", "verdict"), [(1.96, "differs"), (1.999, "match")])
def test_what_pitch_costs_is_a_share_of_the_limit_of_heave_alone(safe, verdict):
    numbers = {"heave_only_limit": 2.0, "safe_speed": safe, "saddle_heave": -3.0}
    numbers |= {"safe_speed_error": 0.01, "heave_only_limit_error": 0.02}
    motion = {"heave": ("time", [0.0, -1.0, -2.0, 1.0]), "pitch": ("time", [0.01, -0.1, -0.2, 0.9])}
    data = xr.Dataset(numbers | {"saddle_pitch": -math.pi / 18})
    found = finding("one_freedom", trim=data, pitching=(coupled(2.25, **motion),))
    assert (
        "trims by the stern as it sinks, by 11.5 degrees up to its lowest point (completed)"
        in found.note
    )
    assert f"costs {50 * (2 - safe):.1f} %" in str(found.here)
    assert "10 degrees" in found.note
    assert found.verdict == verdict


def pitching(coupling, solves, status="completed"):
    factors = "time", [0.1, -0.3, 0.2]
    data = {"iterations": ("time", [0, *solves]), "predicted_contraction": factors}
    return coupled(2.25, status, **data).assign_attrs(coupling=coupling)


def test_a_new_freedom_is_judged_by_how_its_run_ends_beside_the_one_without_it():
    alone = (pitching("printed", [4, 6]),)
    good = finding("new_freedoms", pitching=(pitching("printed", [9, 11]),), transients=alone)
    assert good.here == "heave and pitch: completed, 10.0 solves a step"
    assert "greatest predicted |G| 0.30; heave alone: 5.0 and 0.30" in good.note
    assert good.verdict == "match"
    for status, verdict in (("diverged", "differs"), ("overtrimmed", "match")):
        lost = pitching("printed", [9, 11], status)
        assert finding("new_freedoms", pitching=(lost,)).verdict == verdict


@pytest.mark.parametrize(("fresh", "verdict"), [([5, 7], "match"), ([15, 7], "differs")])
def test_a_refreshed_matrix_is_worth_what_it_saves(fresh, verdict):
    runs = pitching("printed", [9, 11]), pitching("consistent", fresh)
    assert finding("refreshed_matrix", pitching=runs).verdict == verdict


def test_rows_of_a_table_are_named_by_their_keys(tmp_path):
    cell = {"current": "2", "quantity": "stable", "paper": "-0.8", "here": "-0.81"}
    cell |= {"difference": "-0.01", "verdict": "match", "note": ""}
    pd.DataFrame([cell]).to_csv(tmp_path / "table7.csv", index=False)
    (row,) = table_rows(tmp_path / "table7.csv")
    assert row["where"] == "Table 7"
    assert row["claim"].startswith("Table 7: ")
    assert "paper" not in row["claim"]
    assert row["here"] == "-0.81"
    assert row["unit"] == "m"


def test_quantities_of_a_table_have_their_own_units(tmp_path):
    cells = [{"quantity": name, "paper": "1", "here": "1"} for name in ("H", "H_over_T")]
    rest = {"difference": "0", "verdict": "match", "note": ""}
    pd.DataFrame([cell | rest for cell in cells]).to_csv(tmp_path / "table6.csv", index=False)
    assert [row["unit"] for row in table_rows(tmp_path / "table6.csv")] == ["m", "1"]


def test_a_table_is_made_of_its_own_kind_of_dataset_only(case, tmp_path):
    path = tmp_path / "equilibria.nc"
    records.save(
        equilibria(case("equilibria", "added_mass_ratio=1")), path, {"task": "equilibria"}, 0.0
    )
    write_table(TableCase(name="table7", data=str(path)), tmp_path / "table7.csv")
    assert set(pd.read_csv(tmp_path / "table7.csv")["verdict"]) <= {"match", "differs"}
    with pytest.raises(InputError, match="holds 'equilibria' in place of"):
        write_table(TableCase(name="table4", data=str(path)), tmp_path / "table4.csv")
