"""A multirun as a whole: its jobs by name, their progress in one place, the failed ones."""

import fcntl
import logging
import os
import re
import shutil
import tempfile
import threading
import traceback
from collections import Counter, deque
from collections.abc import Iterator, Sequence
from contextlib import suppress
from pathlib import Path
from typing import Any, ClassVar, Literal

from hydra import compose, initialize_config_dir
from hydra._internal.config_loader_impl import get_overrides_dirname
from hydra._internal.core_plugins.basic_sweeper import BasicSweeper
from hydra.core.global_hydra import GlobalHydra
from hydra.core.override_parser.overrides_parser import OverridesParser
from hydra.core.utils import JobReturn
from hydra.errors import HydraException
from hydra.experimental.callback import Callback
from omegaconf import DictConfig

from squat import sweeps
from squat.cli.log import refuse, start_logging
from squat.config import CONF
from squat.config.messages import condense
from squat.errors import InputError
from squat.progress import hide, progress
from squat.sweeps.folders import job_folder

Outcome = Literal["done", "skipped", "failed"]
_NUMBER = re.compile(r"[-+.\deE]+")
_log = logging.getLogger(__name__)
_MARKS = ".jobs-"
_LOOK = 0.2
"""Seconds between two looks at what has ended."""


def check(overrides: Sequence[str]) -> None:
    """Refuse a multirun with a choice that does not exist, before any of its jobs begins."""
    with initialize_config_dir(str(CONF), version_base="1.3"):
        jobs = _combinations([word for word in overrides if not word.startswith("hydra")])
        tasks = sorted({word for job in jobs for word in job if word.startswith("task=")})
        if len(tasks) > 1:
            raise InputError(f"{' '.join(tasks)}: a multirun has one task; start one for each")
        seen: set[str] = set()
        for job in jobs:
            new = {word for word in job if not _numeric(word)} - seen
            if new:
                _compose(job, jobs)
                seen |= new


def _compose(job: list[str], jobs: list[list[str]]) -> None:
    """Compose one of `jobs`; raises InputError that says which, by what not all of them have."""
    if (error := _refused(job)) is None:
        return
    own = " ".join(word for word in job if not all(word in other for other in jobs))
    line = condense(error, job)
    key, unknown, _ = line.partition(": unknown key; ")
    if unknown and (taken := _taken(jobs)):
        has, lacks = (" ".join(w for w in a if w not in b) for a, b in ((taken, job), (job, taken)))
        raise InputError(f"{key}: a key of {has}, not of {lacks}; put it into a file of its own")
    raise InputError(f"{line} (with {own})" if own else line)


def _taken(jobs: list[list[str]]) -> list[str] | None:
    """A job that composes, if one does; of those that differ by numbers one is tried."""
    tried = {tuple(word for word in job if not _numeric(word)): job for job in jobs}
    return next((job for job in tried.values() if _refused(job) is None), None)


def _numeric(word: str) -> bool:
    return _NUMBER.fullmatch(word.partition("=")[2]) is not None


def _refused(job: list[str]) -> HydraException | None:
    """Why Hydra does not compose `job`; None: it does."""
    try:
        compose("config", job)
    except HydraException as error:
        return error
    return None


def _combinations(overrides: Sequence[str]) -> list[list[str]]:
    """Overrides of each job of a multirun, in Hydra's order."""
    parser = OverridesParser.create(GlobalHydra.instance().config_loader())
    parsed = parser.parse_overrides(list(overrides))
    return [job for batch in BasicSweeper.split_arguments(parsed, None) for job in batch]


class Jobs(Callback):
    """Hydra's callback; the start and the end are called in the main process, jobs in workers."""

    failed: ClassVar[bool] = False
    job_started: ClassVar[bool] = False
    outcome: ClassVar[Outcome] = "done"
    earlier: ClassVar[str] = ""
    """How the complete run that is skipped says that it ended."""
    _board: ClassVar["Board | None"] = None

    def __init__(self) -> None:
        self.marks = ""

    @classmethod
    def reset(cls) -> None:
        """Forget earlier runs of this process."""
        cls.failed = cls.job_started = False

    def on_multirun_start(self, config: DictConfig, **kwargs: Any) -> None:
        """Write the plan, and watch the jobs end."""
        start_logging(config.log_level)
        named, folder = _named(config), Path(config.hydra.sweep.dir).resolve()
        try:
            _check_folder(folder)
            sweeps.write_plan(folder, config.task, named)
            Jobs._board = Board(folder, list(named))
        except (InputError, OSError) as error:
            refuse(str(error))  # of an exception Hydra would warn, and go on
        self.marks = Jobs._board.folder.name
        _log.info("%d jobs in %s", len(named), os.path.relpath(folder))

    def on_job_start(self, config: DictConfig, **kwargs: Any) -> None:
        """One job of many shows no progress of its own."""
        if self.marks:
            hide()

    def on_job_end(self, config: DictConfig, job_return: JobReturn, **kwargs: Any) -> None:
        """Mark the end where the main process looks, unless that is gone."""
        if self.marks and Path(self.marks).is_dir():
            mark = f"{config.hydra.job.num}.{Jobs.outcome}.{Jobs.earlier}"
            (Path(self.marks) / mark).touch()

    @classmethod
    def finish(cls) -> None:
        """Stop watching; note whether any job failed."""
        if cls._board is not None:
            cls.failed = cls._board.close() or cls.failed
            cls._board = None


def _check_folder(folder: Path) -> None:
    """Raise InputError where a sweep cannot write."""
    try:
        folder.mkdir(parents=True, exist_ok=True)
        tempfile.TemporaryFile(dir=folder).close()
    except OSError as error:
        raise InputError(
            f"hydra.sweep.dir={os.path.relpath(folder)}: cannot be written ({error.strerror}); "
            "give another folder"
        ) from error


def _named(config: DictConfig) -> dict[str, list[str]]:
    """Overrides of each job by the name of its folder."""
    style = config.hydra.job.config.override_dirname
    names = {}
    for job in _combinations(list(config.hydra.overrides.task)):
        parsed = OverridesParser.create().parse_overrides(job)
        name = get_overrides_dirname(parsed, list(style.exclude_keys), style.item_sep, style.kv_sep)
        names[job_folder(name) or "."] = job
    return names


class Board:
    """Where jobs mark their ends, on whatever node, and a thread that shows how many have.

    Parameters
    ----------
    sweep
        Folder of the multirun.
    names
        Folders of its jobs in there.
    """

    def __init__(self, sweep: Path, names: list[str]) -> None:
        _clear_marks(sweep)
        self.folder, self._lock = _locked_marks(sweep)
        self._jobs = [sweep / name for name in names]
        self._total = len(names)
        self._seen: set[str] = set()
        self._over = threading.Event()
        self._thread = threading.Thread(target=self._show, daemon=True)
        self._thread.start()

    def close(self) -> bool:
        """Show the last jobs; return whether any failed."""
        self._over.set()
        self._thread.join()
        self.folder.cleanup()
        os.close(self._lock)
        failed = any(name.split(".")[1] == "failed" for name in self._seen)
        return failed or any((job / sweeps.FAILED).exists() for job in self._jobs)

    def _show(self) -> None:
        shown = progress(
            self._ends(), self._total, "jobs", note=self._note, worked=_worked, log=_log
        )
        deque(shown, maxlen=0)

    def _note(self) -> str:
        """How many were skipped, with how they once ended, and how many failed."""
        outcomes = [tuple(name.split(".")[1:]) for name in self._seen]
        earlier = Counter(status for outcome, status in outcomes if outcome == "skipped")
        failed = sum(outcome == "failed" for outcome, _ in outcomes)
        ends = ", ".join(f"{count} {status}" for status, count in sorted(earlier.items()))
        skipped = f"{earlier.total()} skipped ({ends})" if earlier else ""
        return ", ".join(filter(None, [skipped, f"{failed} failed" if failed else ""]))

    def _ends(self) -> Iterator[str]:
        seen, marks = self._seen, set[str]()
        while len(seen) < self._total:
            last = self._over.wait(_LOOK)
            with suppress(FileNotFoundError):  # somebody cleaned up: no job can tell its end
                marks = {mark.name for mark in Path(self.folder.name).iterdir()}
            for name in sorted(marks - seen):
                seen.add(name)
                yield name
            if last:
                return


def _locked_marks(sweep: Path) -> tuple["tempfile.TemporaryDirectory[str]", int]:
    """A new folder for marks and its handle, locked for as long as it is open."""
    while True:
        folder = tempfile.TemporaryDirectory(dir=sweep, prefix=_MARKS)
        with suppress(FileNotFoundError):  # taken for a leftover before it is locked
            handle = os.open(folder.name, os.O_RDONLY)
            with suppress(OSError):  # a file system without locks has nothing cleared either
                fcntl.flock(handle, fcntl.LOCK_EX)
            if Path(folder.name).is_dir():
                return folder, handle
            os.close(handle)


def _clear_marks(sweep: Path) -> None:
    """Remove what sweeps left that were killed: their locks are gone."""
    for old in sweep.glob(f"{_MARKS}*"):
        with suppress(OSError):
            handle = os.open(old, os.O_RDONLY)
            try:
                fcntl.flock(handle, fcntl.LOCK_EX | fcntl.LOCK_NB)
                shutil.rmtree(old, ignore_errors=True)
            finally:
                os.close(handle)


def _worked(mark: str) -> bool:
    return mark.split(".")[1] != "skipped"


def note_failure(folder: Path, error: Exception, line: str, expected: bool) -> None:
    """Leave the reason in the job's folder; of an error that nobody expected, all of it.

    Where that cannot be written either, the log alone has it.
    """
    trace = "" if expected else "".join(traceback.format_exception(error))
    with suppress(OSError):
        (folder / sweeps.FAILED).write_text(f"{line}\n{trace}", encoding="utf-8")
