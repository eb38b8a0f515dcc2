"""The graph: completes, does nothing twice, reruns just what depends, survives a kill.

Its jobs run in forks; tests/faults/test_graph.py starts each as `make reproduce` does.
"""

import os
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path

import pandas as pd
import pytest

from squat.records import read
from tests.forks import Forks
from tests.report.page import Page

ROOT = Path(__file__).parents[2]
BIN = Path(sys.executable).parent
RESULTS = "elsewhere"
SMALL = ("--config", "cases=small", f"results={RESULTS}")
PARTS = ("Snakefile", "conf", "squat", "workflows", "profiles")


def environment(folder, path):
    return {**os.environ, "PYTHONPATH": str(folder), "PATH": path, "OMP_NUM_THREADS": "1"}


def snakemake(folder, path, *arguments):
    command = [str(BIN / "snakemake"), "--cores", "2", *arguments, *SMALL]
    return subprocess.run(
        command,
        cwd=folder,
        env=environment(folder, path),
        capture_output=True,
        text=True,
        check=False,
        timeout=1200,
    )


def copy(folder):
    """The source tree as a clone would hold it, so that tests may change its configuration."""
    for part in PARTS:
        if (ROOT / part).is_dir():
            shutil.copytree(
                ROOT / part, folder / part, ignore=shutil.ignore_patterns("__pycache__")
            )
        else:
            shutil.copy(ROOT / part, folder / part)
    return folder


def started(folder, path, *arguments):
    """A run of the graph in a process group of its own."""
    return subprocess.Popen(
        [str(BIN / "snakemake"), "--cores", "2", *arguments, *SMALL],
        cwd=folder,
        env=environment(folder, path),
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
        start_new_session=True,
    )


def killed(folder, path, once):
    """Run the graph, `once` first, and end all its processes as soon as that is there."""
    process = started(folder, path, "all", "--prioritize", once)
    while not (folder / once).exists() and process.poll() is None:
        time.sleep(0.05)
    assert process.poll() is None
    os.killpg(process.pid, signal.SIGKILL)
    process.wait()


@pytest.fixture(scope="module")
def source(tmp_path_factory):
    return copy(tmp_path_factory.mktemp("graph"))


@pytest.fixture(scope="module")
def path(source):
    """Where the graph in `source` finds its commands."""
    forks = Forks(source)
    yield forks.path()
    forks.close()


@pytest.fixture(scope="module")
def interrupted(source, path):
    killed(source, path, f"{RESULTS}/tables/table7.csv")
    assert not (source / RESULTS / "report.html").exists()
    return source


@pytest.fixture(scope="module")
def tree(interrupted, path):
    """The small graph's results, of a run that was killed and one that went on."""
    unlock = [sys.executable, "workflows/unlock.py"]
    subprocess.run(unlock, cwd=interrupted, env=environment(interrupted, path), check=True)
    stamp = (interrupted / RESULTS / "equilibria/equilibria.nc").stat().st_mtime_ns
    done = snakemake(interrupted, path, "all", "--rerun-incomplete")
    assert done.returncode == 0, done.stderr[-3000:]
    assert (interrupted / RESULTS / "equilibria/equilibria.nc").stat().st_mtime_ns == stamp
    return interrupted


def test_everything_promised_is_left(tree):
    results = tree / RESULTS
    for name in ("piston/iterations", "equilibria/equilibria", "mesh/mesh"):
        read(results / f"{name}.nc")
    assert read(results / "stability" / "convergence.nc").sizes["level"] == 3
    for name in ("table4", "table5", "table6", "fig7", "sensitivity"):
        read(results / "added_mass" / f"{name}.nc")
    for name in (*(f"table{n}" for n in range(1, 8)), "table5_critical"):
        frame = pd.read_csv(results / "tables" / f"{name}.csv", dtype=str)
        assert {"paper", "here", "difference", "verdict", "note"} <= set(frame.columns)
        assert set(frame["verdict"]) <= {"match", "differs", "paper inconsistent"}
    verdicts = pd.read_csv(results / "tables" / "verdicts.csv", dtype=str)
    columns = ["claim", "where", "paper", "here", "unit", "verdict", "note"]
    assert list(verdicts.columns) == columns
    numbered = [f"fig{n}" for n in (3, 5, 6, 7, 8, 9, 10)]
    for figure in (*numbered, "mesh_quality", "sensitivity", "iterations", "race"):
        assert (results / "figures" / f"{figure}.png").read_bytes().startswith(b"\x89PNG")
        assert "<svg" in (results / "figures" / f"{figure}.svg").read_text()
    recordings = sorted((results / "replay").glob("*.rrd"))
    assert {one.name.split("_")[0] for one in recordings} == {"piston", "transient"}
    for recording in recordings:
        room, _, run = recording.stem.partition("_")
        assert (results / room / f"{run}.nc").exists()
        assert recording.stat().st_size < 12e6


def test_report_shows_every_figure_and_table_and_needs_no_network(tree, case):
    results = tree / RESULTS
    page = Page(results / "report.html")
    assert page.faults == []
    blocks = list(case("report").contents.blocks)
    for folder, kind in (("figures", "figure"), ("tables", "table")):
        drawn = {path.stem for path in (results / folder).iterdir()} - {"verdicts"}
        assert drawn == {getattr(block, kind) for block in blocks} - {None}


def test_every_job_leaves_a_log_and_a_benchmark_of_its_own(tree, path):
    logs = {path.stem for path in (tree / RESULTS / "logs").iterdir()}
    assert logs == {path.stem for path in (tree / RESULTS / "benchmarks").iterdir()}
    assert {"iterations", "figure_iterations", "equilibria", "table2", "verdicts"} <= logs
    done = snakemake(tree, path, "all", "--detailed-summary")
    head, *rows = (line.split("\t") for line in done.stdout.splitlines() if "\t" in line)
    rule, log = head.index("rule"), head.index("log-file(s)")
    rules = {}
    for row in rows:
        rules.setdefault(row[log], set()).add(row[rule])
    assert len(rules) == len(logs)
    assert [found for found in rules.values() if len(found) > 1] == []


def test_every_attribute_is_explained(tree):
    intro, *sections = (ROOT / "docs/datasets.md").read_text().split("\n## ")
    for path in (tree / RESULTS).rglob("*.nc"):
        attributes = read(path).attrs
        kind = attributes["schema"].split("/")[1]
        (section,) = (one for one in sections if one.startswith(f"`{kind}`:"))
        unexplained = [name for name in attributes if f"`{name}`" not in intro + section]
        assert unexplained == [], path


def test_second_run_does_nothing(tree, path):
    done = snakemake(tree, path, "all", "--dry-run")
    assert "Nothing to be done" in done.stdout + done.stderr


def test_a_changed_value_reruns_just_what_depends_on_it(tree, path):
    file = tree / "conf" / "hull" / "rectangle.yaml"
    before = file.read_text()
    file.write_text(before.replace("40.0", "41.0"))
    try:
        done = snakemake(tree, path, "all", "--dry-run")
    finally:
        file.write_text(before)
    text = done.stdout + done.stderr
    jobs = text[text.index("Job stats") :].split("total")[0]
    assert "equilibria" in jobs
    assert "figure_fig10" in jobs
    assert "iterations" not in jobs


def test_no_rule_holds_a_physics_number():
    for path in (ROOT / "workflows/rules").glob("*.smk"):
        for line in path.read_text().splitlines():
            code = line.split("#")[0]
            assert not any(word.replace(".", "").isdigit() and "." in word for word in code.split())


def test_lint_asks_for_nothing_but_containers(path):
    done = snakemake(ROOT, path, "--lint")
    points = [line.strip() for line in done.stderr.splitlines() if line.strip().startswith("* ")]
    known = (
        "conda environment or container",
        "Param results is a prefix",
    )  # the report reads a folder
    assert [point for point in points if not any(text in point for text in known)] == []


def test_a_killed_run_that_went_on_leaves_no_half_written_file(tree):
    assert (tree / RESULTS / "report.html").exists()
    assert not list(tree.glob(f"{RESULTS}/**/.*-*.nc"))
    assert not (tree / "results").exists()
