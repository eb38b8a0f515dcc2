"""Many runs a job: a scheduler's queue is no place for a thousand jobs of three seconds."""

from collections.abc import Sequence
from pathlib import Path
from typing import Any, Literal

from hydra.core.singleton import Singleton
from hydra.core.utils import JobReturn
from hydra_plugins.hydra_submitit_launcher.config import BaseQueueConf
from hydra_plugins.hydra_submitit_launcher.submitit_launcher import SlurmLauncher

_COMMON = BaseQueueConf.__dataclass_fields__.keys()
_OURS = "submitit_folder", "max_num_timeout"


class Batches(SlurmLauncher):
    """submitit's launcher with `runs_per_job` runs in each job of its array, one after another.

    Parameters
    ----------
    runs_per_job
        Runs in a job.
    cluster
        `slurm`, or `local` for processes of this machine.
    queue
        The keys of submitit's own launcher: `partition`, `timeout_min`, `mem_gb`, ...
    """

    def __init__(self, runs_per_job: int, cluster: Literal["slurm", "local"], **queue: Any) -> None:
        super().__init__(**queue)
        self.runs_per_job = runs_per_job
        self.cluster = cluster

    def launch(
        self, job_overrides: Sequence[Sequence[str]], initial_job_idx: int
    ) -> Sequence[JobReturn]:
        """Submit all runs of a sweep and wait for them; the order of the answers is theirs."""
        import submitit  # noqa: PLC0415  (Hydra imports every plugin at every start)

        assert self.config is not None
        Path(str(self.config.hydra.sweep.dir)).mkdir(parents=True, exist_ok=True)
        executor = submitit.AutoExecutor(self.params["submitit_folder"], cluster=self.cluster)
        queue = {key: value for key, value in self.params.items() if key not in _OURS}
        executor.update_parameters(
            **{key if key in _COMMON else f"slurm_{key}": value for key, value in queue.items()}
        )
        runs = [
            (list(overrides), "hydra.sweep.dir", number, f"run_{number}", Singleton.get_state())
            for number, overrides in enumerate(job_overrides, initial_job_idx)
        ]
        size = self.runs_per_job
        batches = [runs[first : first + size] for first in range(0, len(runs), size)]
        jobs = executor.map_array(self.run_batch, batches)
        return [answer for job in jobs for answer in job.results()[0]]

    def run_batch(self, runs: Sequence[tuple[Any, ...]]) -> list[JobReturn]:
        """Do the runs of one job; one that fails does not stop the others."""
        return [self(*run) for run in runs]
