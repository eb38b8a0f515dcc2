"""`python -m tests.forks.server ADDRESS` runs `squat` for each client, until its input ends."""

import gc
import json
import os
import select
import signal
import socket
import sys
from contextlib import suppress
from pkgutil import resolve_name

from squat.__main__ import main
from squat.cli.tasks import DATASETS, FILES, GROUPED
from tests import kept


def load():
    """Import what the tasks do, so that no fork has to; but rerun, whose threads no fork has."""
    files = (name for task, (_, name) in FILES.items() if task != "replay")
    for name in (*DATASETS.values(), *GROUPED.values(), *files):
        resolve_name(name)
    kept.begin()


def serve(listener):
    """Attend to clients, each in a process; returns in a fork that has to run the command."""
    while True:
        ready, _, _ = select.select([listener, sys.stdin], [], [])
        if listener not in ready:
            return False
        client, _ = listener.accept()
        if os.fork() == 0:
            listener.close()
            return attend(client)
        client.close()


def attend(client):
    """Fork the command and tell the client its end; a client that is killed takes it along."""
    signal.signal(signal.SIGCHLD, signal.SIG_DFL)
    _, streams, _, _ = socket.recv_fds(client, 1, 3)
    request = json.loads(client.makefile().readline())
    child = os.fork()
    if child == 0:
        client.close()
        become(request, streams)
        return True
    for stream in streams:
        os.close(stream)
    select.select([client, os.pidfd_open(child)], [], [])
    with suppress(BlockingIOError):
        if client.recv(1, socket.MSG_DONTWAIT) == b"":
            os.kill(child, signal.SIGKILL)
    _, status = os.waitpid(child, 0)
    with suppress(BrokenPipeError):
        client.sendall(f"{os.waitstatus_to_exitcode(status)}\n".encode())
    os._exit(0)


def become(request, streams):
    """Take arguments, folder, environment and streams of a request."""
    os.environ.clear()
    os.environ.update(request["environment"])
    os.chdir(request["cwd"])
    sys.argv = request["arguments"]
    for number, stream in enumerate(streams):
        os.dup2(stream, number)
        os.close(stream)


if __name__ == "__main__":
    signal.signal(signal.SIGCHLD, signal.SIG_IGN)  # no zombies
    load()
    gc.freeze()  # a search for garbage would copy every page that a fork shares
    with socket.socket(socket.AF_UNIX) as door:
        door.bind(sys.argv[1])
        door.listen()
        print("ready", flush=True)
        wanted = serve(door)
    if wanted:
        main()
