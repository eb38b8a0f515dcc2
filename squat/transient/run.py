"""One coupled run, from the case to its dataset, all at once or from where it was killed."""

import logging
import time
from collections.abc import Iterator
from typing import NamedTuple

import xarray as xr

from squat.coupling import State, Step, repeated
from squat.progress import progress
from squat.records import Segments
from squat.records.trees import copy
from squat.transient.case import TransientCase
from squat.transient.dataset import dataset
from squat.transient.history import History
from squat.transient.parts import Parts, prepare
from squat.transient.snapshots import fields

_log = logging.getLogger(__name__)


class Result(NamedTuple):
    """The record of a run and its snapshots (None where none were asked for)."""

    dataset: xr.Dataset
    fields: xr.Dataset | None


def run(case: TransientCase, segments: Segments | None = None) -> Result:
    """Dataset of kind `transient`; a run that ends early says so in its `status`.

    Parameters
    ----------
    segments
        Where the run keeps its state and history as it goes, and goes on from if it finds some;
        the caller clears them once the result is safe. None: nowhere.

    Notes
    -----
    Bytes do not depend on whether and where the run was interrupted: at every `restart.interval`
    steps it goes on from a copy of its state with solvers that remember nothing.
    """
    parts = prepare(case)
    history = History(case, parts)
    for segment in segments.read() if segments else ():
        history.extend(segment.content)
    if not history.rows:
        history.begin(start(case, parts))
    elif segments and history.steps:
        _log.info("%s: going on from step %d of %d", segments.out, history.steps, case.time.steps)
    steps = _stretches(history, segments)
    for step in progress(steps, case.time.steps, "time steps", history.steps):
        history.take(step)
    history.complete()
    return Result(dataset(history), fields(parts, history.snapshots) if case.snapshots else None)


def start(case: TransientCase, parts: Parts) -> State:
    """State at t = 0: at q(0) in steady flow, at rest unless surge has a velocity."""
    begin = parts.problem.at_rest if case.coupling.start == "rest" else parts.problem.balanced
    motion, memory = begin(*case.start, parts.dt)
    return State((motion,), memory)


def _stretches(history: History, segments: Segments | None) -> Iterator[Step]:
    """Steps up to the end of the run, in stretches of `restart.interval`; `history` takes them."""
    restart, total = history.case.restart, history.case.time.steps
    interval = restart.interval or total
    kept, written = len(history.rows) if history.steps else 0, time.monotonic()
    while history.status is None:
        yield from _stretch(history, min(interval, total - history.steps))
        rested = time.monotonic() - written >= restart.pause
        if segments and restart.interval and rested and history.status is None:
            segments.write(kept, len(history.rows), history.since(kept))
            kept, written = len(history.rows), time.monotonic()


def _stretch(history: History, count: int) -> Iterator[Step]:
    """At most `count` steps from a copy of the state, with solvers that remember nothing."""
    parts = history.parts
    parts.forget()
    for step in repeated(parts.advance, copy(history.state), count):
        yield step
        if history.status is not None:
            return
