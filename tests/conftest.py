"""Shared by all tests: cases composed as the command line composes them."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

from squat.config import compose, validate

ROOT = Path(__file__).parents[1]


@pytest.fixture(scope="session")
def root():
    return ROOT


@pytest.fixture(scope="session")
def case():
    """The checked case of `squat task=<task> <overrides>`."""
    return lambda task, *overrides: validate(compose(task, *overrides)).case


@pytest.fixture
def squat(tmp_path):
    """Run the real command in an empty folder."""

    def run(*arguments, cwd=tmp_path, timeout=120):
        command = [str(Path(sys.executable).parent / "squat"), *arguments]
        return subprocess.run(
            command,
            cwd=cwd,
            capture_output=True,
            text=True,
            timeout=timeout,
            check=False,
            env={**os.environ, "OMP_NUM_THREADS": "1"},
        )

    return run
