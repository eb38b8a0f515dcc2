"""Runs generated bad input through the command in this process: COUNT SEED; JSON lines of faults.

The command is the real one. Two things are taken from it for speed, and neither sees the input:
what Hydra read from `conf/` and gmsh's triangles are kept (tests/kept.py), and of input that turns
out to be good only its geometry is made where a run would take long.
"""

import contextlib
import importlib
import io
import json
import os
import signal
import sys
import tempfile
from collections import Counter
from pathlib import Path

from squat import records
from squat.cli.tasks import FILES, run_task
from squat.errors import InputError
from squat.mesh import MeshSize, submesh
from squat.mesh.count import check_count
from tests import kept
from tests.fuzz.files import prepare
from tests.fuzz.inputs import Generator

command = importlib.import_module("squat.cli.main")
PATIENCE = 120
"""Seconds after which a case counts as hung."""
_QUICK = {"equilibria", *FILES}


class HungError(BaseException):
    """Raised by the alarm."""


def light(valid, path):
    """Run a good input where that is quick; else make its geometry."""
    case, task = valid.case, valid.settings.task
    given = getattr(case, "added_mass_ratio", 0.0) is not None
    if task in _QUICK and given and getattr(getattr(case, "speeds", None), "points", 0) < 5000:
        run_task(valid, path)
        return
    with records.claim(path):
        pass
    if hasattr(case, "hull") and hasattr(case, "channel"):
        coarse = submesh(case.hull, case.channel)
        if isinstance(getattr(case, "mesh", None), MeshSize):
            check_count(coarse, case.mesh)
    inputs = getattr(case, "inputs", None)
    for name in ("mesh", "reduced", "added_mass", "equilibria"):
        if getattr(inputs, name, None) is not None:
            records.read(Path(getattr(inputs, name)), records.KINDS[name])


def _hung(*_):
    raise HungError


def one(arguments):
    """Exit code, stdout, stderr of the command; what else it raised."""
    sys.argv = ["squat", *arguments]
    out, err, raised, code = io.StringIO(), io.StringIO(), "", 0
    signal.signal(signal.SIGALRM, _hung)
    signal.alarm(PATIENCE)
    try:
        with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
            command.main()
    except SystemExit as end:
        code = end.code if isinstance(end.code, int) else 1
    except BaseException as error:
        raised = f"{type(error).__name__}: {error}"
    finally:
        signal.alarm(0)
    return code, out.getvalue(), err.getvalue(), raised


def tree():
    """Names and sizes of all files here."""
    return {str(p): p.lstat().st_size for p in Path().rglob("*") if not p.is_dir()}


def judge(bad, done, before):
    """What is wrong with how a case ended; empty where nothing is."""
    code, _, err, raised = done
    if raised:
        return f"raised {raised}"
    if Path("evil.flag").exists():
        return "executed the target"
    if code == 0:
        return _nonsense()
    err = "".join(line for line in err.splitlines(True) if " passed over, " not in line)
    faults = {
        f"exit code {code}": code != 2,
        "not one line": err.count("\n") != 1 or not err.startswith("squat: "),
        "a very long line": len(err) > 700,
        f"left behind {set(tree()) ^ set(before)}": tree() != before,
        "names neither key nor value": bad.names
        and not any(_printed(name) in err for name in bad.names),
    }
    return "; ".join([f"{fault}: {err[:500]!r}" for fault, found in faults.items() if found][:1])


def _printed(name):
    """The part of a key or value that a line must show: no quotes, no end of a long one."""
    return name.strip("' ").partition("\x00")[0][:60]


def _nonsense():
    """A dataset just written that cannot be read or holds no finite number."""
    for path in Path().glob("*.nc"):
        if path.name == "equilibria.nc":
            try:
                data = records.read(path)
            except InputError as error:
                return f"wrote a broken file: {error}"
            if not bool(data["speed"].notnull().all()):
                return f"{path}: not a number"
    return ""


def main(count, seed):
    """Print faults and, last, the counts."""
    kept.begin()
    command.run_task = light
    made = Generator(seed)
    counts, faults = Counter(), 0
    with tempfile.TemporaryDirectory(prefix="squat-fuzz-") as name:
        os.chdir(name)
        prepared = prepare(Path())
        for number in range(count):
            bad = made.bad()
            before = tree()
            done = one(bad.arguments)
            if fault := judge(bad, done, before):
                faults += 1
                found = {"n": number, "sort": bad.sort, "argv": bad.arguments, "fault": fault}
                print(json.dumps(found), flush=True)
            counts[bad.sort, "refused" if done[0] == 2 else "accepted"] += 1
            for path in set(tree()) - prepared:
                Path(path).unlink(missing_ok=True)
            if number % 500 == 499:
                print(json.dumps({"done": number + 1, "faults": faults}), flush=True)
        os.chdir("/")
    table = {f"{sort} {how}": number for (sort, how), number in sorted(counts.items())}
    print(json.dumps({"cases": count, "faults": faults, **table}))


if __name__ == "__main__":
    main(int(sys.argv[1]), int(sys.argv[2]))
