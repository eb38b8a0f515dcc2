"""A command loads what its task needs and no more: a person waits for every import."""

import subprocess
import sys

import pytest

from squat.cli.tasks import FILES

HEAVY = ("gmsh", "matplotlib", "rerun", "scipy", "shapely", "skfem", "sphinx")


def loaded(code):
    """Which of the heavy libraries a new interpreter has after `code`."""
    code = f"import sys, squat.cli\n{code}\nprint(*{{*{HEAVY}}} & {{*sys.modules}})"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    return set(done.stdout.split())


@pytest.mark.parametrize(
    ("task", "needed"), [("difference", set()), ("collect", set()), ("figure", {"matplotlib"})]
)
def test_a_case_is_checked_without_the_libraries_of_other_tasks(task, needed):
    assert loaded(f"from squat.config import CASES\nCASES[{task!r}]") <= needed


@pytest.mark.parametrize(
    ("task", "needed"),
    [
        ("table", {"scipy"}),
        ("verdicts", {"scipy"}),
        ("catalogue", set()),
        ("difference", set()),
        ("figure", {"matplotlib"}),
        ("compare", {"matplotlib"}),
        ("report", {"scipy"}),
        ("replay", {"matplotlib", "rerun", "scipy", "shapely"}),
    ],
)
def test_what_shows_results_loads_no_solver_of_them(task, needed):
    """No mesh and no elements; pictures have no root to find either."""
    assert loaded(f"from pkgutil import resolve_name\nresolve_name({FILES[task][1]!r})") <= needed


def test_the_command_is_the_module(squat):
    module = [sys.executable, "-m", "squat", "--version"]
    done = subprocess.run(module, capture_output=True, text=True, check=True)
    assert done.stdout == squat("--version").stdout != ""
