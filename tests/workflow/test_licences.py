"""docs/licences.md: complete, as the packages say, and nothing in it forbids MIT."""

from importlib.metadata import version

import pytest

from workflows.licences import WINDOWS, Entry, compatible, entries, licence, locked


@pytest.fixture(scope="module")
def page(root):
    lines = (root / "docs" / "licences.md").read_text("utf-8").splitlines()
    rows = [line.strip("| ").split(" | ") for line in lines if line.count(" | ") == 2]
    return {name: Entry(name, *rest) for name, *rest in rows if name != "package"}


def test_the_page_lists_exactly_what_is_locked(page):
    assert sorted(page) == locked()
    assert {"numpy", "gmsh", "snakemake", "pytest"} <= page.keys()


def test_every_licence_is_known_and_lets_squat_be_mit(page):
    assert [one for one in page.values() if not compatible(one)] == []


def test_the_page_says_what_the_packages_say(page, root):
    """Other versions than the one that is locked, or one of several, may say it in other words."""
    lock = (root / "requirements.lock").read_text("utf-8")
    for one in entries():
        alone = lock.count(f"\n{one.name}==") == 1
        known = one.name in WINDOWS or (alone and f"\n{one.name}=={version(one.name)}" in lock)
        assert page[one.name] == one or not known


@pytest.mark.parametrize("text", ["GPL-3.0-only", "AGPL-3.0", "unknown", "Proprietary", "SSPL-1.0"])
def test_what_would_forbid_it_is_noticed(text):
    assert not compatible(Entry("x", text, "run"))
    assert compatible(Entry("x", "LGPL-2.1-or-later", "run"))
    assert "GPL" in licence("gmsh")
