"""`python -m workflows.mutants [room ...]`: sample, try, report; goes on where it was killed."""

import argparse
import csv
import hashlib
import importlib
import json
import os
import random
import sys
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import NamedTuple

import coverage
import hypothesis

from workflows.mutants.mutations import Mutation, mutate, mutations
from workflows.mutants.trial import SURVIVED, attempt, record

ROOT = Path(__file__).parents[2]
STATE = ROOT / ".mutants"
LISTED = Path(__file__).with_name("equivalent.csv")
ROOMS: dict[str, tuple[tuple[str, ...], tuple[str, ...]]] = {
    "coupling": (("coupling", "piston", "external"), ()),
    "dynamics": (("dynamics",), ()),
    "fem": (("fem",), ()),
    "stability": (("stability",), ()),
    "fluid": (("fluid", "stability", "transient"), ()),
    "analysis": (("analysis", "paper"), ("sources",)),
}
"""Folders of tests that must notice a change of a room; fixtures that it has no part in."""
LEAST_KILLED = 0.9
_PATIENCE, _GRACE = 4.0, 60.0
_PRELOADED = ("numpy", "scipy.sparse.linalg", "scipy.optimize", "xarray", "pandas", "skfem")
_PRELOADED_TOO = ("gmsh", "matplotlib.pyplot", "hydra", "pydantic", "h5netcdf", "shapely")


class Outcome(NamedTuple):
    """A mutation and what became of it."""

    mutation: Mutation
    outcome: str


class Baseline:
    """Which tests of a room reach which line, and how long each takes."""

    def __init__(self, room: str) -> None:
        tests, self.kept = ROOMS[room]
        folders = [f"tests/{name}" for name in tests]
        sources = [ROOT / "squat", ROOT / "conf", *(ROOT / folder for folder in folders)]
        self.folder = STATE / room / _digest(*sources)
        if not (self.folder / "seconds.json").exists():
            record(folders, room, self.folder, self.kept)
        self.seconds: dict[str, float] = json.loads((self.folder / "seconds.json").read_text())
        self.data = coverage.CoverageData(str(self.folder / "coverage"))
        self.data.read()

    def tests(self, mutation: Mutation) -> list[str]:
        """Tests that reach the mutated statement, fastest first; then the others of their files.

        These may look at what the former made once for all. A statement that only an import runs
        is reached by the tests that reach anything of its file, or by all where none does.
        """
        lines = self.data.contexts_by_lineno(str(ROOT / mutation.file))
        here = [lines.get(n, []) for n in range(mutation.line, mutation.last_line + 1)]
        contexts = {name for names in here for name in names}
        if contexts == {""}:
            contexts = {name for names in lines.values() for name in names}
        found = {name.rsplit("|", 1)[0] for name in contexts if name}
        files = {_file(name) for name in found}
        beside = [name for name in self.seconds if _file(name) in files] or list(self.seconds)
        return sorted(beside, key=lambda name: (name not in found, self.seconds[name], name))


def _file(test: str) -> str:
    return test.split("::", maxsplit=1)[0]


def judge(mutation: Mutation, baseline: Baseline) -> str:
    """SURVIVED, KILLED or TIMEOUT."""
    tests = baseline.tests(mutation)
    if not tests:
        return SURVIVED
    module = mutation.file.removesuffix(".py").removesuffix("/__init__").replace("/", ".")
    patience = _GRACE + _PATIENCE * sum(baseline.seconds[name] for name in tests)
    tree = mutate(ROOT, mutation)
    return attempt(module, tree, tests, baseline.folder, baseline.kept, patience)


def sample(room: str, count: int, seed: int) -> list[Mutation]:
    """`count` mutations of each file of a room, or all if they are fewer."""
    chosen = []
    for path in sorted((ROOT / "squat" / room).rglob("*.py")):
        file = path.relative_to(ROOT).as_posix()
        every = mutations(ROOT, file)
        chosen += random.Random(f"{seed} {file}").sample(every, min(count, len(every)))
    return chosen


def try_room(room: str, count: int, seed: int) -> list[Outcome]:
    """Outcomes of a room's sample; what is known of the same sources is not tried anew."""
    baseline = Baseline(room)
    memory = baseline.folder / "outcomes.json"
    known = json.loads(memory.read_text()) if memory.exists() else {}
    outcomes = []
    for mutation in sample(room, count, seed):
        name = f"{mutation.file} {mutation.place} {mutation.variant}"
        if name not in known:
            known[name] = judge(mutation, baseline)
            memory.write_text(json.dumps(known))
            print(f"{known[name]:9}{mutation.file}:{mutation.line}  {mutation.after}", flush=True)
        outcomes.append(Outcome(mutation, known[name]))
    return outcomes


def equivalent() -> set[tuple[str, str, str]]:
    """File, statement before and after of the changes proved to change nothing."""
    with LISTED.open(newline="") as file:
        return {(row["file"], row["before"], row["after"]) for row in csv.DictReader(file)}


def report(room: str, outcomes: list[Outcome]) -> tuple[int, int, int]:
    """Print the tally and the unexplained survivors; sampled, killed and unexplained."""
    listed = equivalent()
    alive = [m for m, outcome in outcomes if outcome == SURVIVED]
    unexplained = [m for m in alive if (m.file, m.before, m.after) not in listed]
    killed = len(outcomes) - len(alive)
    share = killed / max(len(outcomes), 1)
    print(f"{room}: {len(outcomes)} sampled, {killed} killed ({share:.0%}), ", end="")
    print(f"{len(alive) - len(unexplained)} equivalent, {len(unexplained)} survived")
    for m in unexplained:
        print(f"  {m.file}:{m.line}\n    - {m.before}\n    + {m.after}")
    return len(outcomes), killed, len(unexplained)


def main() -> int:
    """Exit code 1 where too few are killed or a survivor is not explained."""
    parser = argparse.ArgumentParser(prog="python -m workflows.mutants")
    parser.add_argument("rooms", nargs="*", default=list(ROOMS), help=", ".join(ROOMS))
    parser.add_argument("--per-file", type=int, default=3)
    parser.add_argument("--seed", type=int, default=2023)
    options = parser.parse_args()
    for name in (*_PRELOADED, *_PRELOADED_TOO):
        importlib.import_module(name)
    hypothesis.settings.register_profile(
        "mutants",
        derandomize=True,
        database=None,
        deadline=None,
        phases=(hypothesis.Phase.explicit, hypothesis.Phase.generate),
    )
    hypothesis.settings.load_profile("mutants")
    with TemporaryDirectory(prefix="squat-kept-") as folder:
        os.environ["SQUAT_KEPT"] = folder  # tests/kept.py: meshes, in which no room has a part
        tally = [
            report(room, try_room(room, options.per_file, options.seed)) for room in options.rooms
        ]
    sampled, killed, unexplained = (sum(column) for column in zip(*tally, strict=True))
    print(f"all: {sampled} sampled, {killed} killed ({killed / sampled:.1%}), {unexplained} open")
    return int(unexplained > 0 or killed < LEAST_KILLED * sampled)


def _digest(*folders: Path) -> str:
    found = hashlib.sha256()
    for folder in folders:
        for path in sorted(folder.rglob("*")):
            if path.is_file() and path.suffix in {".py", ".yaml", ".csv"}:
                found.update(path.relative_to(ROOT).as_posix().encode() + path.read_bytes())
    return found.hexdigest()[:12]


if __name__ == "__main__":
    sys.exit(main())
