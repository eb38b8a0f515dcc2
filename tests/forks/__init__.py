"""The command `squat` in forks of one process that has imported it, a second or two saved a run.

What a fork runs is the command, in its own process and folder, with its own streams; only the
imports are done. Whether those are few is what tests/cli/test_startup.py asks real interpreters.
"""

import atexit
import os
import subprocess
import sys
from pathlib import Path
from tempfile import TemporaryDirectory

ROOT = Path(__file__).parents[2]
_CLIENT = Path(__file__).with_name("client.py")
_ONE_THREAD = dict.fromkeys(("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS"), "1")


class Forks:
    """A server of the source tree in `root`, and a folder with a program `squat` that asks it."""

    def __init__(self, root: Path = ROOT):
        self._folder = TemporaryDirectory(prefix="squat-")
        self.bin = Path(self._folder.name)
        self.program = self.bin / "squat"
        address = self.bin / "address"
        self._server = subprocess.Popen(
            [sys.executable, "-m", "tests.forks.server", str(address)],
            cwd=root,
            env={**os.environ, **_ONE_THREAD, "PYTHONPATH": str(ROOT)},
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
        )
        atexit.register(self.close)
        assert self._server.stdout.readline() == b"ready\n"
        code = f"#!{sys.executable} -IS\n{_CLIENT.read_text()}main({str(address)!r})\n"
        self.program.write_text(code)
        self.program.chmod(0o755)

    def close(self):
        """End the server; what it runs goes on."""
        self._server.kill()
        self._server.wait()
        self._folder.cleanup()

    def path(self):
        """What PATH has to be for a shell, or a graph, to find that `squat` first."""
        return f"{self.bin}:{Path(sys.executable).parent}:{os.environ['PATH']}"

    def run(self, arguments, cwd, timeout):
        """The completed process; `subprocess.TimeoutExpired` after `timeout` [s]."""
        command = [str(self.program), *arguments]
        return subprocess.run(
            command, cwd=cwd, timeout=timeout, capture_output=True, text=True, check=False
        )
