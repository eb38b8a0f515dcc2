"""Tests in a forked process: of the code as it is, and with one module changed."""

import ast
import importlib.machinery
import json
import os
import pickle
import signal
import sys
import time
import traceback
from collections.abc import Callable, Iterator
from pathlib import Path
from types import CodeType
from typing import Any

import joblib
import pytest

_POLL = 0.05
_BROKEN = 70
_LONGEST = 3600.0
_QUIET = ["-q", "-p", "no:cacheprovider", "-p", "no:xdist", "--tb=line"]
_QUIET += ["-W", "ignore::pytest.PytestAssertRewriteWarning"]  # hypothesis is imported already
SURVIVED, KILLED, TIMEOUT = "survived", "killed", "timeout"


class Recorder:
    """Pytest plugin: the seconds of every test; session fixtures `kept` in files of `folder`."""

    def __init__(self, folder: Path, kept: tuple[str, ...]) -> None:
        self.folder, self.kept = folder, kept
        self.seconds: dict[str, float] = {}

    def pytest_runtest_logreport(self, report: Any) -> None:
        """Add up set-up and call."""
        if not report.passed:
            raise RuntimeError(f"{report.nodeid} fails on the code as it is")
        self.seconds[report.nodeid] = self.seconds.get(report.nodeid, 0.0) + report.duration

    @pytest.hookimpl(wrapper=True)
    def pytest_fixture_setup(self, fixturedef: Any) -> Iterator[Any]:
        """Keep what a fixture returns."""
        value = yield
        if fixturedef.argname in self.kept:
            (self.folder / fixturedef.argname).write_bytes(pickle.dumps(value))
        return value

    def pytest_sessionfinish(self) -> None:
        """Write the seconds."""
        (self.folder / "seconds.json").write_text(json.dumps(self.seconds))


class Selected:
    """Pytest plugin: only the tests named, in that order; fixtures that were kept."""

    def __init__(self, tests: list[str], folder: Path, kept: tuple[str, ...]) -> None:
        self.order = {name: number for number, name in enumerate(tests)}
        self.folder, self.kept = folder, kept

    def pytest_collection_modifyitems(self, items: list[Any]) -> None:
        """Choose and sort."""
        items[:] = sorted(
            (item for item in items if item.nodeid in self.order),
            key=lambda item: self.order[item.nodeid],
        )

    def pytest_fixture_setup(self, fixturedef: Any, request: Any) -> Any:
        """Take a fixture that the mutated room has no part in from its file."""
        if fixturedef.argname not in self.kept:
            return None
        value = pickle.loads((self.folder / fixturedef.argname).read_bytes())
        fixturedef.cached_result = (value, fixturedef.cache_key(request), None)
        return value


class _Changed(importlib.machinery.SourceFileLoader):
    """Loads a module from a changed syntax tree."""

    tree: ast.Module

    def get_code(self, fullname: str) -> CodeType:
        """Compile the tree; no bytecode is read or written."""
        return compile(self.tree, self.path, "exec")


class _Finder(importlib.machinery.PathFinder):
    """Finds one module in its changed form and leaves all others to Python."""

    def __init__(self, module: str, tree: ast.Module) -> None:
        self.module, self.tree = module, tree

    def find_spec(self, fullname: str, path: Any = None, target: Any = None) -> Any:  # type: ignore[override]
        """Find the module."""
        if fullname != self.module:
            return None
        spec = super().find_spec(fullname, path, target)
        assert spec is not None
        assert spec.origin is not None
        spec.loader = _Changed(fullname, spec.origin)
        spec.loader.tree = self.tree
        return spec


def record(folders: list[str], room: str, folder: Path, kept: tuple[str, ...]) -> None:
    """Run the tests of a room with coverage; leave `seconds.json` and `coverage` in `folder`.

    Raises
    ------
    RuntimeError
        A test fails.
    """
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "coveragerc").write_text(f"[run]\ndata_file = {folder / 'coverage'}\n")
    how = ["--cov-branch", "--cov-context=test", "--cov-report="]
    config = f"--cov-config={folder / 'coveragerc'}"
    arguments = [*_QUIET, f"--cov=squat.{room}", config, *how, *folders]

    def run() -> int:
        with joblib.parallel_config(backend="sequential"):  # coverage sees this process alone
            return int(pytest.main(arguments, [Recorder(folder, kept)]))

    code = _forked(run, folder / "log", _LONGEST)
    if code != 0:
        (folder / "seconds.json").unlink(missing_ok=True)  # or the next run takes it for a record
        raise RuntimeError(f"{room}: a test fails on the code as it is; see {folder / 'log'}")


def attempt(
    module: str,
    tree: ast.Module,
    tests: list[str],
    folder: Path,
    kept: tuple[str, ...],
    seconds: float,
) -> str:
    """SURVIVED, KILLED or TIMEOUT: what `tests` make of a changed module."""

    def run() -> int:
        sys.meta_path.insert(0, _Finder(module, tree))
        files = sorted({name.split("::")[0] for name in tests})
        with joblib.parallel_config(backend="sequential"):  # new processes would not be changed
            return int(pytest.main([*_QUIET, "-x", *files], [Selected(tests, folder, kept)]))

    code = _forked(run, folder / "log", seconds)
    if code is None:
        return TIMEOUT
    if code in (_BROKEN, pytest.ExitCode.NO_TESTS_COLLECTED):
        raise RuntimeError(f"{module}: no test was found; see {folder / 'log'}")
    return SURVIVED if code == 0 else KILLED


def _forked(run: Callable[[], int], log: Path, seconds: float) -> int | None:
    """Exit code of `run` in a process group of its own; None where it took too long."""
    sys.stdout.flush()
    child = os.fork()
    if child == 0:
        _become(log)
        code = _BROKEN
        try:
            code = int(run())
        except BaseException:  # whatever happens, this copy of the parent must end here
            traceback.print_exc()
        sys.stdout.flush()
        os._exit(code)
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        done, status = os.waitpid(child, os.WNOHANG)
        if done:
            return os.waitstatus_to_exitcode(status)
        time.sleep(_POLL)
    os.killpg(child, signal.SIGKILL)
    os.waitpid(child, 0)
    return None


def _become(log: Path) -> None:
    """Let this process speak to a file alone, and be killed with its own children."""
    os.setsid()
    output = os.open(log, os.O_WRONLY | os.O_CREAT | os.O_TRUNC)
    for stream in (1, 2):
        os.dup2(output, stream)
