"""Failed jobs of a multirun: none stops the others, all are named at the end."""

import time
from pathlib import Path
from typing import Any, ClassVar

from hydra.experimental.callback import Callback
from omegaconf import DictConfig

FAILED = "failed.txt"
"""File in a job's folder that says why the job failed."""


_CLOCK = 0.01  # s, coarseness of file times


class Failures(Callback):
    """Tells `main`, in its process, whether any job failed, in whatever process."""

    found: ClassVar[bool] = False
    job_started: ClassVar[bool] = False
    since: ClassVar[float] = 0.0

    @classmethod
    def reset(cls) -> None:
        """Forget earlier runs of this process."""
        cls.found = cls.job_started = False

    def on_multirun_start(self, config: DictConfig, **kwargs: Any) -> None:
        """Note the time: older failures in the same folder are another sweep's."""
        Failures.since = time.time()

    def on_multirun_end(self, config: DictConfig, **kwargs: Any) -> None:
        """Look through the job folders of the sweep."""
        notes = Path(config.hydra.sweep.dir).glob(f"**/{FAILED}")
        Failures.found = any(note.stat().st_mtime >= Failures.since - _CLOCK for note in notes)
