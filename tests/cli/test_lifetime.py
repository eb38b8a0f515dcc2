"""What a killed sweep leaves on the terminal."""

import subprocess
import sys

import pytest

from squat.lifetime import leave_quietly

WARNS = "import warnings; warnings.warn('resource_tracker: 8 leaked'); warnings.warn('own')"


@pytest.mark.parametrize("said", ["", "ignore:own"])
def test_only_the_resource_tracker_is_silenced(said, monkeypatch):
    monkeypatch.setenv("PYTHONWARNINGS", said)
    leave_quietly()
    leave_quietly()
    done = subprocess.run([sys.executable, "-c", WARNS], capture_output=True, text=True, check=True)
    assert "leaked" not in done.stderr
    assert ("UserWarning: own" in done.stderr) == (said == "")
