"""The report: whole, self-contained, complete, the same every time."""

import re
import shutil
from pathlib import Path

import numpy as np
import pandas as pd
import pytest
from matplotlib.figure import Figure

import squat as api
from squat import published, records
from squat.analysis.verdict import DIFFERS, FEW_DIGITS, INCONSISTENT, MATCH
from squat.errors import InputError
from squat.figures.files import save
from squat.records.stability_kinds import CONVERGENCE
from squat.report import write_report
from squat.report.provenance import digest
from squat.report.tables import grid
from tests.report.page import DOI, Page

HOW = {"refinement": 2.0, "safety": 1.25}
ESTIMATES = {
    "quantity": ["2D squat speed", "period"],
    "current": [np.nan, 2.0],
    "unit": ["m s-1", "s"],
    "refined": ["mesh", "time step"],
    "level_value": [[3.0, 2.5, 2.25], [np.nan] * 3],
    "observed_order": [1.0, np.nan],
    "value": [2.0, np.nan],
    "error": [0.3125, np.nan],
}
NAMES = ["claim", "where", "paper", "here", "unit", "verdict", "note"]


def spaced(page):
    return " ".join(re.sub(r"<[^>]*>", " ", page).split())


@pytest.fixture(scope="module")
def report(case):
    return lambda results: case("report", f'results="{results}"')


@pytest.fixture
def results(tmp_path, whole):
    """A folder of results in which all that is printed is also computed."""
    return Path(shutil.copytree(whole, tmp_path, dirs_exist_ok=True))


@pytest.fixture(scope="module")
def whole(tmp_path_factory, report):
    folder = tmp_path_factory.mktemp("results")
    contents = report(folder).contents
    for name in filter(None, (block.figure for block in contents.blocks)):
        figure = Figure(figsize=(1, 1))
        figure.add_subplot().plot(np.arange(3))
        (folder / "figures").mkdir(exist_ok=True)
        save(figure, folder / "figures" / f"{name}.png")
    (folder / "tables").mkdir()
    rows = []
    for name in filter(None, (block.table for block in contents.blocks)):
        cells = [
            {**cell.keys, "paper": cell.text, "here": cell.text, "verdict": MATCH, "note": ""}
            for cell in published.table(name)
        ]
        rows += [{**cell, "claim": f"{name} {n}"} for n, cell in enumerate(cells)]
        pd.DataFrame(cells).to_csv(folder / "tables" / f"{name}.csv", index=False)
    claims = published.claims()
    rows += [{**row, "here": "<b>", "verdict": DIFFERS} for row in claims.to_dict("records")]
    rows[-1]["verdict"] = INCONSISTENT
    frame = pd.DataFrame(rows).reindex(columns=NAMES)
    frame.to_csv(folder / "tables" / "verdicts.csv", index=False)
    for name in filter(None, (block.estimates for block in contents.blocks)):
        records.save(records.build(CONVERGENCE, ESTIMATES, HOW), folder / name, {}, 0.0)
    run = api.run("transient", "mesh=coarse", "accuracy.near=0.4", "time.periods=0.03")
    run.to_netcdf(folder / "run.nc", engine="h5netcdf")
    for name in {block.of for block in contents.blocks if block.table}:
        (folder / name).parent.mkdir(exist_ok=True)
        shutil.copy(folder / "run.nc", folder / name)
    return folder


def test_runs_of_another_configuration_are_left_out_and_named(results, case):
    """Those of a sweep that was changed stay in its folder."""
    (results / "transient").mkdir()
    for name in ("printed_2.25", "printed_2.3"):
        shutil.copy(results / "run.nc", results / "transient" / f"{name}.nc")
    members = f'members=["{results}/transient/printed_2.3.nc"]'
    write_report(case("report", f'results="{results}"', members), results / "report.html")
    text = (results / "report.html").read_text()
    rows, told = text.split("Left out are 1 ")
    assert "transient/printed_2.25.nc" not in rows
    assert told.index("transient/printed_2.25.nc") < told.index("</p>")
    for name in ("run.nc", "transient/printed_2.3.nc"):
        assert f'<a href="{name}">' in told


def test_the_page_is_whole_and_loads_nothing(results, report):
    write_report(report(results), results / "report.html")
    page = Page(results / "report.html")
    assert page.faults == []
    assert len(page.pictures) == sum(1 for b in report(results).contents.blocks if b.figure)
    frame = pd.read_csv(results / "tables" / "verdicts.csv")
    text = " ".join("".join(page.words).split())
    for verdict, count in frame["verdict"].value_counts().items():
        assert f"{count} {verdict.replace('differs', 'differ')}" in text
    assert str(results) not in page.text
    table4 = page.text.split('id="table4"')[1].split("</div>\n</div>")[0]
    assert 'href="added_mass/table4.nc"' in table4
    assert "&lt;b&gt;" in page.text
    assert "2D squat speed mesh 3 2.5 2.25 1.00 2.00 +- 3.1e-01 m/s" in spaced(page.text)
    assert "period at 2 m/s time step – – – – none" in spaced(page.text)
    before = page.text
    write_report(report(results), results / "report.html")
    assert (results / "report.html").read_text() == before


def test_every_sentence_and_table_of_the_paper_has_one_place(report):
    blocks = list(report("results").contents.blocks)
    claims = [name for block in blocks for name in block.claims or ()]
    assert sorted(claims) == sorted(published.claims().index)
    tables = [block.table for block in blocks if block.table]
    assert tables == [*(f"table{n}" for n in range(1, 6)), "table5_critical", "table6", "table7"]


@pytest.mark.parametrize(
    "name",
    ["figures/fig10.svg", "tables/table3.csv", "tables/verdicts.csv", "added_mass/table5.nc"],
)
def test_what_is_missing_is_named(results, report, name):
    (results / name).unlink()
    with pytest.raises(InputError, match=rf"{name}.*run snakemake all first"):
        write_report(report(results), results / "report.html")
    assert not (results / "report.html").exists()


def test_a_block_shows_one_thing(case):
    parts = "contents.parts=[{title: a, sections: [{title: b, blocks: [{title: c}]}]}]"
    with pytest.raises(
        InputError, match="a block has one of figure, table, claims, runs, estimates, files"
    ):
        case("report", parts)


def test_provenance_depends_on_physics_and_not_on_paths():
    config = api.compose("transient")
    moved = {**config, "out": "elsewhere.nc", "inputs": {**config["inputs"], "mesh": "other.nc"}}
    assert digest(moved) == digest(config)
    assert digest({**config, "current": 2.0}) != digest(config)


def test_the_page_names_units_one_note_and_the_papers_address(results, report):
    table = results / "tables" / "table6.csv"
    frame = pd.read_csv(table, dtype=str, keep_default_na=False)
    frame.loc[0, ["verdict", "note"]] = [DIFFERS, "deeper"]
    frame.to_csv(table, index=False)
    write_report(report(results), results / "report.html")
    page = Page(results / "report.html")
    assert [link for link in page.links if link.startswith("http")] == [DOI]
    assert "V_inf_min [m/s]" in page.text
    assert "Note on 1 cell</summary>" in page.text


def test_a_match_by_few_digits_has_its_note_at_the_table():
    cell = {"depth_over_draft": "2.5", "source": "wendel_1956", "paper": "1", "here": "0.906"}
    rows = [{**cell, "verdict": MATCH, "note": note} for note in ("estimates", FEW_DIGITS)]
    quiet, telling = (grid("table4", pd.DataFrame([row])).notes for row in rows)
    assert not quiet
    assert [note for _, note in telling] == [FEW_DIGITS]
