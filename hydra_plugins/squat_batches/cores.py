"""Runs over the cores of this machine, by processes that end with the sweep."""

import os
from collections.abc import Sequence

from hydra.core.utils import JobReturn
from hydra_plugins.hydra_joblib_launcher.joblib_launcher import JoblibLauncher

from squat.lifetime import end_with, leave_quietly


class Cores(JoblibLauncher):
    """joblib's launcher, whose workers watch the main process before they load anything else."""

    def launch(
        self, job_overrides: Sequence[Sequence[str]], initial_job_idx: int
    ) -> Sequence[JobReturn]:
        """Do all runs of a sweep; the order of the answers is theirs."""
        leave_quietly()
        self.joblib |= {"initializer": end_with, "initargs": (os.getpid(),)}
        return super().launch(job_overrides, initial_job_idx)
