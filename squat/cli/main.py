"""Entry point: Hydra composes, the schema checks, one task runs; errors are one line."""

import logging
import os
import sys
from pathlib import Path

import hydra
from hydra.core.hydra_config import HydraConfig
from hydra.errors import HydraException
from hydra.types import RunMode
from omegaconf import DictConfig
from omegaconf.errors import OmegaConfBaseException

from squat.cli.messages import condense
from squat.cli.tasks import run_task
from squat.config import CONF, validate
from squat.config.compose import plain
from squat.errors import InputError

BAD_INPUT = 2


def main() -> None:
    """Run `squat`; exit code 0 for any result, 2 for bad input."""
    os.environ["HYDRA_FULL_ERROR"] = "1"  # errors reach this function instead of Hydra's printer
    try:
        _entry()
    except InputError as error:
        sys.exit(_fail(str(error)))
    except (HydraException, OmegaConfBaseException) as error:
        sys.exit(_fail(condense(error, sys.argv[1:])))


def _fail(line: str) -> int:
    print(f"squat: {line}", file=sys.stderr)
    return BAD_INPUT


@hydra.main(version_base="1.3", config_path=str(CONF), config_name="config")
def _entry(config: DictConfig) -> None:
    job = HydraConfig.get()
    multirun = job.mode == RunMode.MULTIRUN
    try:
        valid = validate(plain(config))
        logging.basicConfig(
            format="%(levelname)s %(message)s", level=valid.settings.log_level.upper(), force=True
        )
        run_task(valid, _folder(valid.settings.out, Path(job.runtime.output_dir), multirun))
    except (InputError, OmegaConfBaseException) as error:
        line = str(error) if isinstance(error, InputError) else condense(error, sys.argv[1:])
        if not multirun:
            raise InputError(line) from error
        _fail(f"job {job.job.override_dirname or job.job.num}: {line}")
        raise InputError("some jobs failed, named above; all others are complete") from error


def _folder(out: str | None, folder: Path, multirun: bool) -> Path:
    """Where relative outputs go: the working directory, or the job's own in a multirun."""
    if multirun and out is not None and Path(out).is_absolute():
        raise InputError(f"out={out}: every job would write it; give a relative path in a multirun")
    return folder if multirun else Path()
