"""Shared by all tests: cases composed as the command line composes them."""

import os
from pathlib import Path

import pytest
from xdist.scheduler import LoadScopeScheduling

from squat.config import compose, validate
from tests import kept
from tests.forks import Forks

ROOT = Path(__file__).parents[1]
LONGEST = tuple(
    f"tests/{room}/"
    for room in ("workflow", "paper", "docs", "faults", "trim", "transient", "fluid", "fuzz", "cli")
)
"""Folders that begin first, so that no worker waits for another at the end."""


if "PYTEST_XDIST_WORKER" in os.environ:  # the other workers have the other cores
    os.environ.setdefault("LOKY_MAX_CPU_COUNT", "1")


kept.begin()


class Scheduling(LoadScopeScheduling):
    """A module to a worker, all of the paper's to one: they share datasets that take a minute."""

    def _split_scope(self, nodeid):
        return "tests/paper" if nodeid.startswith("tests/paper/") else super()._split_scope(nodeid)


@pytest.hookimpl(optionalhook=True)  # the plugin may be off
def pytest_xdist_make_scheduler(config, log):
    config.option.loadscopereorder = False  # by the number of tests, which says nothing of time
    return Scheduling(config, log)


def pytest_collection_modifyitems(items):
    first = {folder: place for place, folder in enumerate(LONGEST)}
    items.sort(key=lambda item: first.get("/".join(item.nodeid.split("/")[:2]) + "/", len(first)))


@pytest.fixture(scope="session")
def root():
    return ROOT


@pytest.fixture(scope="session")
def case():
    """The checked case of `squat task=<task> <overrides>`."""
    return lambda task, *overrides: validate(compose(task, *overrides)).case


@pytest.fixture(scope="session")
def forks():
    return Forks()


@pytest.fixture
def squat(tmp_path, forks):
    """Run the real command in an empty folder."""

    def run(*arguments, cwd=tmp_path, timeout=120):
        return forks.run(arguments, cwd, timeout)

    return run
