"""The command `squat` in forks of one process that has imported it, a second saved for each run.

`python -m tests.forks` reads requests, one JSON object a line, and answers each with the exit code.
"""

import atexit
import json
import os
import signal
import subprocess
import sys
from pathlib import Path
from tempfile import TemporaryDirectory

import squat.cli  # noqa: F401  (what takes the second)
from squat.__main__ import main


class Forks:
    """Runs the command as a shell would, each time in a process of its own."""

    def __init__(self):
        self._server = subprocess.Popen(
            [sys.executable, "-m", "tests.forks"],
            cwd=Path(__file__).parents[1],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            text=True,
        )
        atexit.register(self._server.kill)

    def run(self, arguments, cwd, timeout):
        """The completed process; one that takes longer than `timeout` [s] is killed."""
        with TemporaryDirectory() as folder:
            files = [Path(folder) / name for name in ("stdout", "stderr")]
            request = {
                "arguments": ["squat", *arguments],
                "cwd": str(cwd),
                "files": [str(file) for file in files],
                "timeout": timeout,
                "environment": dict(os.environ),
            }
            self._server.stdin.write(json.dumps(request) + "\n")
            self._server.stdin.flush()
            code = int(self._server.stdout.readline())
            said = [file.read_text(encoding="utf-8") for file in files]
        return subprocess.CompletedProcess(request["arguments"], code, *said)


def serve():
    """Answer requests until there are no more; returns in a fork that has to run the command."""
    for line in sys.stdin:
        if os.fork() == 0:
            become(json.loads(line))
            return True
        _, status = os.wait()
        print(os.waitstatus_to_exitcode(status), flush=True)
    return False


def become(request):
    """Take arguments, folder, environment and streams of a request."""
    signal.alarm(request["timeout"])
    os.environ.clear()
    os.environ.update(request["environment"])
    os.chdir(request["cwd"])
    sys.argv = request["arguments"]
    for number, name in enumerate([os.devnull, *request["files"]]):
        flags = os.O_WRONLY | os.O_CREAT if number else os.O_RDONLY
        os.dup2(os.open(name, flags), number)


if __name__ == "__main__" and serve():
    main()
