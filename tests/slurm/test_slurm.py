"""The graph and a sweep on a real SLURM: `make test-slurm`."""

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from squat.catalogue import find
from squat.records import read
from tests.slurm.cluster import Cluster

pytestmark = pytest.mark.slurm
ROOT = Path(__file__).parents[2]
BIN = Path(sys.executable).parent
PARTS = ("Snakefile", "conf", "squat", "hydra_plugins", "workflows", "profiles")


@pytest.fixture(scope="module")
def cluster(tmp_path_factory):
    with Cluster(tmp_path_factory.mktemp("slurm")) as started:
        yield started


def run(folder, *command):
    environment = {**os.environ, "PATH": f"{BIN}:{os.environ['PATH']}", "PYTHONPATH": str(folder)}
    environment |= {"OMP_NUM_THREADS": "1"}
    done = subprocess.run(
        command,
        cwd=folder,
        env=environment,
        capture_output=True,
        text=True,
        check=False,
        timeout=500,
    )
    assert done.returncode == 0, done.stdout[-3000:] + done.stderr[-5000:]
    return done.stdout + done.stderr


def test_the_coupled_runs_of_the_graph_share_jobs_on_both_nodes(cluster, tmp_path):
    for part in PARTS:
        copy = shutil.copytree if (ROOT / part).is_dir() else shutil.copy
        copy(ROOT / part, tmp_path / part)
    before = len(cluster.jobs)
    command = "snakemake results/tables/table1.csv results/tables/table7.csv"
    wanted = [f"results/transient/{name}_1.0.nc" for name in ("printed", "printed_standard")]
    done = run(
        tmp_path,
        *command.split(),
        *wanted,
        "--workflow-profile=workflows/profiles/slurm",
        "--config",
        "cases=small",
        "--slurm-init-seconds-before-status-checks=3",
        "--seconds-between-status-checks=2",
    )
    assert "Finished" in done
    for path in wanted:
        read(tmp_path / path)
    jobs = cluster.jobs[before:]
    assert {job["JobState"] for job in jobs} == {"COMPLETED"}
    rules = 2 + 2 + 4
    assert len(jobs) < rules


def test_a_sweep_of_many_runs_makes_few_jobs(cluster, tmp_path):
    before = len(cluster.jobs)
    ratios = [round(0.2 + 0.1 * n, 1) for n in range(24)]
    launcher = ["hydra/launcher=slurm", "hydra.launcher.runs_per_job=6"]
    launcher += ["hydra.launcher.partition=main", "hydra.launcher.timeout_min=10"]
    sweep = f"piston.mass_ratio={','.join(map(str, ratios))}"
    run(tmp_path, "squat", "-m", *launcher, "task=piston", "time.periods=0.1", sweep)
    table = find([tmp_path / "multirun"])
    assert sorted(table["piston.mass_ratio"]) == ratios
    jobs = cluster.jobs[before:]
    assert len(jobs) == 4
    assert {job["JobState"] for job in jobs} == {"COMPLETED"}
    assert {job["NodeList"] for job in jobs} == {"n1", "n2"}
