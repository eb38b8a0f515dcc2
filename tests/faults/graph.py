"""The graph under SIGKILL: whole process groups ended at random moments, and the physics after."""

import json
import os
import random
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path
from typing import NamedTuple

import psutil

from squat.records import groups, read_group, read_whole
from squat.records.provenance import digest

ROOT = Path(__file__).parents[2]
BIN = Path(sys.executable).parent
PARTS = ("Snakefile", "conf", "squat", "hydra_plugins", "workflows", "profiles")
COMMAND = "python workflows/unlock.py && exec snakemake {targets} --cores 2 --config cases=small"
"""What `make reproduce` runs, smaller."""


_AT_WORK = 0.8
"""Share of the kills that meet jobs at work; the others may come while snakemake starts."""


class Chain(NamedTuple):
    """What a chain of kills met: kills survived, runs completed, stray processes and files."""

    kills: int
    runs: int
    orphans: int


def source(folder):
    """The source tree as a clone would hold it."""
    folder.mkdir(parents=True, exist_ok=True)
    ignored = shutil.ignore_patterns("__pycache__")
    for part in PARTS:
        if (ROOT / part).is_dir():
            shutil.copytree(ROOT / part, folder / part, ignore=ignored)
        else:
            shutil.copy(ROOT / part, folder / part)
    return folder


def start(folder, targets):
    """A run of the graph in a process group of its own, its output in `log`."""
    path = f"{BIN}:{os.environ['PATH']}"
    with (folder / "log").open("wb") as log:
        return subprocess.Popen(
            ["bash", "-c", COMMAND.format(targets=" ".join(targets))],
            cwd=folder,
            env={**os.environ, "PYTHONPATH": str(folder), "PATH": path, "OMP_NUM_THREADS": "1"},
            stdout=log,
            stderr=subprocess.STDOUT,
            start_new_session=True,
        )


def complete(folder, targets):
    """Run the graph to its end."""
    process = start(folder, targets)
    assert process.wait() == 0, (folder / "log").read_text()[-3000:]
    return physics(folder / "results")


def physics(results):
    """Digest of the values in every dataset and of all its groups, and every table, by name."""
    found = {}
    for path in sorted(results.rglob("*.nc")):
        name = str(path.relative_to(results))
        assert not path.name.startswith("."), f"{name}: left behind"
        found[name] = digest(read_whole(path))
        for group in groups(path):
            found[f"{name}/{group}"] = digest(read_group(path, group))
    tables = sorted(results.glob("tables/*.csv"))
    return found | {path.name: path.read_text(encoding="utf-8") for path in tables}


def chain(folder, targets, kills, seed, longest, expected):
    """Kill runs of the graph `kills` times, up to `longest` [s] after their start or first job.

    Most moments are early ones, so that long jobs come to their end between two kills all the same.

    A killed run is continued by the same command; a completed one is compared with `expected`
    and begun anew. The last is completed and compared.
    """
    moments, survived, runs, orphans = random.Random(seed), 0, 0, 0
    while survived < kills:
        process = start(folder, targets)
        if moments.random() < _AT_WORK:
            _until_at_work(folder, process)
        try:
            process.wait(longest * moments.random() ** 3)
        except subprocess.TimeoutExpired:
            os.killpg(process.pid, signal.SIGKILL)
            process.wait()
            orphans += _end_orphans(folder)
            survived += 1
            datasets = len(list((folder / "results").rglob("[!.]*.nc")))
            print(json.dumps({"kills": survived, "runs": runs, "datasets": datasets}), flush=True)
            continue
        assert process.returncode == 0, (folder / "log").read_text()[-3000:]
        assert physics(folder / "results") == expected
        shutil.rmtree(folder / "results")
        runs += 1
    assert complete(folder, targets) == expected
    return Chain(survived, runs + 1, orphans)


def _until_at_work(folder, process):
    """Wait until the first job begins."""
    while b"Job stats" not in (folder / "log").read_bytes() and process.poll() is None:
        time.sleep(0.05)


def _end_orphans(folder):
    """End what a killed run left at work in `folder`; how many there were."""
    count = 0
    for process in psutil.process_iter():
        try:
            if process.cwd() == str(folder) and process.pid != os.getpid():
                process.kill()
                process.wait(10)
                count += 1
        except psutil.Error:
            continue
    return count


if __name__ == "__main__":
    place, number, chance, most = Path(sys.argv[1]), *map(int, sys.argv[2:5])
    wanted = sys.argv[5:] or ["all"]
    (place / "killed").mkdir(parents=True)
    if not (place / "undisturbed").exists():
        complete(source(place / "undisturbed"), wanted)
    truth = physics(place / "undisturbed" / "results")
    print(chain(source(place / "killed"), wanted, number, chance, most, truth))
