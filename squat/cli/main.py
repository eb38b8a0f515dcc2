"""Entry point: Hydra composes, the schema checks, one task runs; errors are one line."""

import logging
import os
import sys
import warnings
from argparse import ArgumentParser
from concurrent.futures.process import BrokenProcessPool
from contextlib import nullcontext
from pathlib import Path
from pkgutil import resolve_name
from typing import NoReturn

import hydra
from hydra._internal.utils import get_args_parser
from hydra.core.hydra_config import HydraConfig
from hydra.types import RunMode
from omegaconf import DictConfig
from omegaconf.errors import OmegaConfBaseException

import squat
from squat.cli.arguments import readable
from squat.cli.jobs import Jobs, check, note_failure
from squat.cli.log import BAD_INPUT, refuse, report, start_logging
from squat.cli.pipes import quiet_end
from squat.cli.targets import guard
from squat.cli.tasks import drop_segments, earlier_end, output, run_task
from squat.config import CONF, validate
from squat.config.messages import condense
from squat.config.raw import plain, plain_choices
from squat.config.schema import Valid
from squat.errors import InputError
from squat.records import BusyError
from squat.sweeps import FAILED

_log = logging.getLogger(__name__)
INTERRUPTED = 130
_ANY_TASK = "task=piston"  # Hydra composes before it prints its help, and a task is mandatory


def main() -> None:
    """Run `squat`; exit code 0 for any result, 2 for bad input, 141 where nobody reads on."""
    with quiet_end():
        _main()


def _main() -> None:
    os.environ["HYDRA_FULL_ERROR"] = "1"  # errors reach this function, not Hydra's printer
    guard()
    _let_hydra_parse()
    warnings.filterwarnings("error", "provider=", UserWarning)  # a search path that does not exist
    Jobs.reset()
    if sys.argv[1:] == ["--version"]:
        print(f"squat {squat.__version__}")
        return
    if {"task=figure", "figure=list"} <= set(sys.argv[1:]):
        print(resolve_name("squat.figures.write:catalogue")())
        return
    try:
        sys.argv[1:] = readable(sys.argv[1:])
        _check_options(sys.argv[1:])
        _entry()
    except KeyboardInterrupt:
        report("interrupted; the same command goes on from here")
        sys.exit(INTERRUPTED)
    except BrokenProcessPool:
        refuse("a job was killed, for want of memory perhaps; the same command goes on from here")
    except BrokenPipeError:
        raise
    except MemoryError:
        refuse(f"not enough memory; give a smaller case (in: {' '.join(sys.argv[1:])})")
    except Exception as error:
        if Jobs.job_started:
            raise  # a bug, not bad input: its traceback is wanted
        refuse(condense(error, sys.argv[1:]))
    finally:
        Jobs.finish()
    if Jobs.failed:
        sys.exit(BAD_INPUT)


def _let_hydra_parse() -> None:
    """Since 3.14 Python's parsers refuse a help text that is no string, and Hydra 1.3 has one."""
    ArgumentParser._check_help = lambda self, action: None  # type: ignore[attr-defined]


def _check_options(arguments: list[str]) -> None:
    """Refuse unknown options in one line, before argparse does in many."""

    def unknown(message: str) -> NoReturn:
        raise InputError(f"{message}; squat --help shows the usage")

    parser = get_args_parser()
    parser.error = unknown  # type: ignore[method-assign]
    options = parser.parse_args(arguments)
    if options.experimental_rerun:
        unknown("--experimental-rerun runs what a pickle holds and is not offered")
    if options.multirun:
        check(options.overrides)
    if options.help and not any(word.startswith("task=") for word in arguments):
        sys.argv.append(_ANY_TASK)


@hydra.main(version_base="1.3", config_path=str(CONF), config_name="config")
def _entry(config: DictConfig) -> None:
    job = HydraConfig.get()
    folder = Path(os.path.relpath(job.runtime.output_dir))
    multirun = job.mode == RunMode.MULTIRUN
    Jobs.job_started, Jobs.outcome, Jobs.earlier = True, "done", ""
    try:
        valid = validate(plain(config), plain_choices(job.runtime.choices))
        with nullcontext() if multirun else quiet_end():  # Hydra has words for any other error
            _run(valid, folder, multirun)
    except Exception as error:
        expected = isinstance(error, (InputError, OmegaConfBaseException)) or (
            isinstance(error, OSError) and error.filename is not None
        )
        if not (expected or multirun):
            raise
        line = condense(error, sys.argv[1:])
        if not expected:
            line = f"unexpected {type(error).__name__}: {error}"
        if multirun:
            if not isinstance(error, BusyError):  # the job may yet succeed, in another process
                note_failure(folder, error, line, expected)
            line = f"{folder.name}: {line}"
        Jobs.failed, Jobs.outcome = True, "failed"
        report(line)


def _run(valid: Valid, folder: Path, multirun: bool) -> None:
    start_logging(valid.settings.log_level)
    out = valid.settings.out
    path = output(valid, folder if multirun else Path())
    if multirun:
        folder.mkdir(parents=True, exist_ok=True)
        if out is not None and Path(out).is_absolute():
            raise InputError(f"out={out}: every job would write it; give a relative path")
        (folder / FAILED).unlink(missing_ok=True)
        if not valid.settings.redo and (status := earlier_end(valid, path)):
            Jobs.outcome, Jobs.earlier = "skipped", status
            drop_segments(path)
            _log.info("%s: complete, skipped (%s); redo=true makes it again", path, status)
            return
    run_task(valid, path)
