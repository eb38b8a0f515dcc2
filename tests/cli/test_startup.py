"""A command loads what its task needs and no more: a person waits for every import."""

import subprocess
import sys

import pytest

from squat.cli.tasks import FILES

HEAVY = ("gmsh", "matplotlib", "rerun", "scipy", "shapely", "skfem", "sphinx")
EACH = f"""
import os, sys, squat.cli
for code in sys.argv[1:]:
    if os.fork() == 0:
        exec(code)
        print(*{{*{HEAVY}}} & {{*sys.modules}}, flush=True)
        os._exit(0)
    assert os.wait()[1] == 0
"""
CHECKED = {"difference": set(), "collect": set(), "figure": {"matplotlib"}}
SHOWN = {
    "table": {"scipy"},
    "verdicts": {"scipy"},
    "catalogue": set(),
    "difference": set(),
    "figure": {"matplotlib"},
    "compare": {"matplotlib"},
    "report": {"scipy"},
    "replay": {"matplotlib", "rerun", "scipy", "shapely"},
}


@pytest.fixture(scope="module")
def loaded():
    """Which of the heavy libraries a process that has the command loads beside it, for a code."""
    codes = [f"from squat.config import CASES\nCASES[{task!r}]" for task in CHECKED]
    codes += [f"from pkgutil import resolve_name\nresolve_name({FILES[t][1]!r})" for t in SHOWN]
    done = subprocess.run(
        [sys.executable, "-c", EACH, "", *codes], capture_output=True, text=True, check=True
    )
    nothing, *lines = [set(line.split()) for line in done.stdout.splitlines()]
    assert nothing == set()
    found = iter(lines)
    return [{task: next(found) for task in tasks} for tasks in (CHECKED, SHOWN)]


@pytest.mark.parametrize("task", CHECKED)
def test_a_case_is_checked_without_the_libraries_of_other_tasks(task, loaded):
    assert loaded[0][task] <= CHECKED[task]


@pytest.mark.parametrize("task", SHOWN)
def test_what_shows_results_loads_no_solver_of_them(task, loaded):
    """No mesh and no elements; pictures have no root to find either."""
    assert loaded[1][task] <= SHOWN[task]


def test_the_command_is_the_module(squat):
    module = [sys.executable, "-m", "squat", "--version"]
    done = subprocess.run(module, capture_output=True, text=True, check=True)
    assert done.stdout == squat("--version").stdout != ""
