"""Dynamic ship squat, and the added-mass effect in partitioned fluid-structure coupling.

What a notebook needs, each name loaded when it is first used:

`run`
    One task as a dataset, without a file: ``squat.run("piston", "piston.mass_ratio=2")``.
`open_run`
    The dataset of an earlier run: labelled arrays with units, checked.
`config_of`
    The configuration that a dataset was made with.
`compose`
    The configuration of a task, without running it.
`find_runs`
    A table of all runs below a folder: configuration, status, headline figures.
`couple`, `Structure`, `Load`
    Your own structure and flow solver in the coupling loop (docs/theory/coupling.md).
`InputError`
    What any of them raises where the request cannot be met: key or file, value, remedy.

>>> import squat
>>> data = squat.run("piston", "scheme=standard", "piston.mass_ratio=0.5", "time.periods=1")
>>> data.attrs["status"], data["position"].attrs["units"]
('converged', 'm')
"""

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from squat.api import compose, find_runs, open_run, run
    from squat.coupling import Load
    from squat.errors import InputError
    from squat.external import Structure, couple
    from squat.records import config_of

    __version__: str

_HOMES = {
    "InputError": "squat.errors",
    "Load": "squat.coupling",
    "Structure": "squat.external",
    "compose": "squat.api",
    "config_of": "squat.records",
    "couple": "squat.external",
    "find_runs": "squat.api",
    "open_run": "squat.api",
    "run": "squat.api",
}
__all__ = [
    "InputError",
    "Load",
    "Structure",
    "compose",
    "config_of",
    "couple",
    "find_runs",
    "open_run",
    "run",
]


def __getattr__(name: str) -> Any:
    """Import what is asked for: a notebook that reads a file shall not wait for the solvers."""
    if name == "__version__":
        return import_module("importlib.metadata").version("squat")
    if name in _HOMES:
        return getattr(import_module(_HOMES[name]), name)
    raise AttributeError(f"module 'squat' has no attribute {name!r}")


def __dir__() -> list[str]:
    return sorted({*globals(), *__all__, "__version__"})
