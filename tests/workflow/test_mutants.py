"""The tool of `make test-mutants`: its changes are changes, and it knows what it cannot see."""

import ast

import pytest

from workflows.mutants.__main__ import Baseline
from workflows.mutants.mutations import mutate, mutations

SOURCE = '''"""Text."""

def area(a: float, b: float = 2.0) -> float:
    """More text."""
    if a < 0:
        raise ValueError(f"{a + 1}")
    return a * b
'''


@pytest.fixture
def folder(tmp_path):
    (tmp_path / "one.py").write_text(SOURCE)
    return tmp_path


def test_each_mutation_is_one_change_that_compiles(folder):
    found = mutations(folder, "one.py")
    texts = [ast.unparse(mutate(folder, one)) for one in found]
    assert len(set(texts)) == len(texts)
    assert ast.unparse(ast.parse(SOURCE)) not in texts
    for text in texts:
        compile(text, "one.py", "exec")


def test_values_signs_comparisons_and_statements_change_but_no_words(folder):
    after = {one.after for one in mutations(folder, "one.py")}
    assert {"if a >= 0:", "if a <= 0:", "if a < 1:", "if a < -1:"} <= after
    assert {"return a / b", "return None", "return 0", "removed"} <= after
    assert {"def area(a: float, b: float=3.0) -> float:"} <= after
    assert len(after) == len(mutations(folder, "one.py")) == 10


class Reached:
    """What coverage would tell of one file."""

    def contexts_by_lineno(self, _):
        return {5: ["a.py::slow|run", "a.py::fast|setup"], 7: ["b.py::x|run"]}


def test_tests_that_reach_a_place_come_first_and_those_that_may_look_at_its_work_follow(folder):
    baseline = object.__new__(Baseline)
    baseline.data = Reached()
    baseline.seconds = {"a.py::fast": 1.0, "a.py::slow": 9.0, "a.py::other": 0.1, "b.py::x": 0.1}
    at = {one.line: one for one in mutations(folder, "one.py")}
    assert baseline.tests(at[5]) == ["a.py::fast", "a.py::slow", "a.py::other"]
    assert baseline.tests(at[7]) == ["b.py::x"]
