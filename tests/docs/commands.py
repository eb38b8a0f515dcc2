"""Run lines of `squat` as the shell would, made cheaper."""

import os
import shlex
import subprocess

CHEAPER = {
    "transient": "mesh=coarse accuracy.near=0.4 time.periods=0.1",
    "mesh": "mesh=coarse",
    "added_mass": "mesh=coarse accuracy.near=0.4",
    "reduced": "mesh=coarse",
    "equilibria": "accuracy=coarse",
    "stability": "mesh=coarse portrait=small",
    "stability_map": "mesh=coarse cases/map@_global_=small",
    "limits": "accuracy=coarse",
    "uneven_bottom": "accuracy=coarse",
    "hull_shapes": "cases/hull_shapes@_global_=small",
    "race": "cases/race@cells=small",
    "trim": "cases/trim@_global_=small",
}
"""Added to a command of a page, unless it says otherwise: its keys are tried, not its time."""


def command(line: str) -> None:
    """Run one line; anything but exit code 0 is an error."""
    words = shlex.split(line, comments=True)
    if words[0] == "cd":
        os.chdir(words[1])
        return
    task = next((word[5:] for word in words if word.startswith("task=")), "")
    given = {word.split("=")[0] for word in words}
    cheaper = "" if "-m" in words else CHEAPER.get(task, "")  # it would name a sweep's folders
    extra = [word for word in cheaper.split() if word.split("=")[0] not in given]
    subprocess.run([words[0], *extra, *words[1:]], check=True, stdin=subprocess.DEVNULL)
