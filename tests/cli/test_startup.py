"""A command loads what its task needs and no more: a person waits for every import."""

import subprocess
import sys

import pytest

HEAVY = ("gmsh", "matplotlib", "rerun", "scipy", "skfem", "sphinx")


@pytest.mark.parametrize(
    ("task", "needed"),
    [("difference", ()), ("collect", ()), ("figure", ("matplotlib", "scipy"))],
)
def test_a_case_is_checked_without_the_libraries_of_other_tasks(task, needed):
    code = (
        "import sys, squat.cli\n"
        "from squat.config import CASES\n"
        f"CASES[{task!r}]\n"
        f"print([name for name in {HEAVY} if name in sys.modules])"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert set(eval(done.stdout)) <= set(needed)
