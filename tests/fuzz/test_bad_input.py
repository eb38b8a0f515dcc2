"""Generated bad input: exit code 2 and one line; nothing is executed, nothing left behind."""

import json
import os
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).parents[2]
CASES = int(os.environ.get("SQUAT_FUZZ", "120"))
"""Generated inputs; `make test-fuzz` gives 10,000."""
PROCESSES = 2


def test_generated_bad_input_is_one_line_and_exit_code_2(capsys):
    share = [str(CASES // PROCESSES)]
    workers = [
        subprocess.Popen(
            [sys.executable, "-m", "tests.fuzz.run", *share, str(seed)],
            cwd=ROOT,
            stdout=subprocess.PIPE,
            text=True,
        )
        for seed in range(PROCESSES)
    ]
    lines = [
        json.loads(line)
        for worker in workers
        for line in worker.communicate()[0].split("\n")
        if line
    ]
    with capsys.disabled():
        for line in lines:
            if "cases" in line:
                print("\n", line)
    assert [line for line in lines if "fault" in line] == []
    assert sum(line.get("cases", 0) for line in lines) == int(share[0]) * PROCESSES
    assert all(worker.returncode == 0 for worker in workers)
