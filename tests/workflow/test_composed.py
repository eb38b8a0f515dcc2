"""Configurations that the Snakefile keeps are those that the command line composes."""

import shutil

import pytest

from squat.config import compose
from workflows.composed import ROOT, Composed, source

WORDS = ("equilibria", "hull.draft=12")


def nobody(*words):
    raise AssertionError(f"{words}: composed again")


@pytest.fixture
def store(tmp_path):
    """A store that has one answer."""
    path = tmp_path / "somewhere" / "composed.json"
    Composed(path)(*WORDS)
    return path


def test_an_answer_is_kept_and_what_the_command_line_composes(store, monkeypatch):
    expected = compose(*WORDS)
    monkeypatch.setattr("squat.config.compose", nobody)
    assert Composed(store)(*WORDS) == expected
    with pytest.raises(AssertionError, match="composed again"):
        Composed(store)("equilibria", "hull.draft=11")


@pytest.mark.parametrize("changed", ["conf/hull/rectangle.yaml", "squat/config/compose.py"])
def test_a_changed_file_forgets_all_answers(store, tmp_path, monkeypatch, changed):
    root = tmp_path / "tree"
    for folder in ("conf", "squat"):
        shutil.copytree(ROOT / folder, root / folder)
    assert source(root) == source(ROOT)
    (root / changed).write_text((ROOT / changed).read_text() + "\n")
    monkeypatch.setattr("squat.config.compose", nobody)
    with pytest.raises(AssertionError, match="composed again"):
        Composed(store, root)(*WORDS)


@pytest.mark.parametrize("text", ["", '{"source": 1', "[]", "{}"])
def test_a_damaged_store_is_written_anew(store, text):
    whole = store.read_text()
    store.write_text(text)
    Composed(store)(*WORDS)
    assert store.read_text() == whole


def test_a_store_that_cannot_be_written_costs_time_only(tmp_path):
    (tmp_path / "file").touch()
    assert Composed(tmp_path / "file" / "composed.json")(*WORDS) == compose(*WORDS)
    assert [path.name for path in tmp_path.iterdir()] == ["file"]
