"""The functions behind `import squat`."""

import time
from collections.abc import Sequence
from os import PathLike
from pathlib import Path
from typing import Any

import pandas as pd
import xarray as xr

from squat import catalogue, records
from squat.errors import InputError


def open_run(path: str | PathLike[str], group: str | None = None) -> xr.Dataset:
    """Dataset that a run wrote, in memory: labelled arrays with units, proved whole.

    Parameters
    ----------
    path
        NetCDF file of any task.
    group
        Name of a group of snapshots (`fields` of task=transient); None: the run itself.

    Returns
    -------
    xarray.Dataset
        Every variable has `units` (UDUNITS) and `long_name`; the attributes hold the
        configuration, versions and how the run ended.

    Raises
    ------
    InputError
        The file is absent, broken, foreign, newer than this squat, or altered.

    Examples
    --------
    >>> import squat
    >>> data = squat.run("piston", "time.periods=1", "piston.mass_ratio=2")
    >>> data.to_netcdf("piston.nc", engine="h5netcdf")
    >>> again = squat.open_run("piston.nc")
    >>> again["velocity"].attrs["units"], squat.config_of(again)["piston"]["mass_ratio"]
    ('m s-1', 2)
    """
    if group is None:
        return records.read(Path(path))
    return records.read_group(Path(path), group)


def run(task: str, *overrides: str) -> xr.Dataset:
    """Dataset of `squat task=<task> <overrides>`, in memory instead of in a file.

    Parameters
    ----------
    task
        A task that makes a dataset: `piston`, `added_mass`, `transient`, ...
    overrides
        `key=value`, as on the command line. Snapshots need a file: they are left out.

    Raises
    ------
    InputError
        One line: the key, its value, the remedy.

    Examples
    --------
    >>> import squat
    >>> roots = squat.run("equilibria", "hull.draft=8")
    >>> bool(roots["squat_speed"] > squat.run("equilibria")["squat_speed"])
    True
    """
    # The solvers take seconds to import, and who reads a file needs none of them.
    from squat import config  # noqa: PLC0415
    from squat.cli.tasks import FILES, TASKS, compute  # noqa: PLC0415

    if task in FILES:
        raise InputError(f"task={task}: makes no dataset; give one of {', '.join(TASKS)}")
    started = time.perf_counter()
    valid = config.validate(*config.composed(task, *overrides))
    return records.stamp(compute(valid), valid.config, started, choices=valid.choices)


def compose(task: str, *overrides: str) -> dict[str, Any]:
    """Configuration of `squat task=<task> <overrides>`, without running it.

    Parameters
    ----------
    task
        Any task.
    overrides
        `key=value`, as on the command line.

    Returns
    -------
    dict
        Plain containers, checked as for a run; what follows from other keys (say, a hull's draft
        from its points) is filled in.

    Raises
    ------
    InputError
        One line, worded as on the command line: the key, its value, the remedy.

    Examples
    --------
    >>> import squat
    >>> squat.compose("equilibria", "hull=lewis", "hull.draft=8")["hull"]["draft"]
    8
    """
    from squat import config  # noqa: PLC0415

    return config.validate(config.compose(task, *overrides)).config


def find_runs(
    folder: str | PathLike[str] = ".",
    where: str = "",
    sort: str | Sequence[str] = (),
) -> pd.DataFrame:
    """Table of all runs below `folder`, one row a file.

    Parameters
    ----------
    folder
        Searched to any depth; a multirun and a folder of results are the same to it.
    where
        A condition on columns, in pandas' query language; names with dots as they are:
        ``piston.mass_ratio == 2``.
    sort
        Column or columns to sort by; ``-name`` is descending.

    Returns
    -------
    pandas.DataFrame
        `file`, `kind`, `status`, the choices by their groups (`hull`), the configuration under
        dotted keys (`hull.draft`), and headline figures (`result.heave_last`, ...); absent ones
        are missing, choices in files of older squats too.

    Examples
    --------
    >>> import squat
    >>> for ratio in (0.5, 2):
    ...     run = squat.run("piston", "scheme=standard", f"piston.mass_ratio={ratio}")
    ...     run.to_netcdf(f"ratio-{ratio}.nc", engine="h5netcdf")
    >>> found = squat.find_runs(".", where="scheme == 'standard'", sort="-piston.mass_ratio")
    >>> list(found["status"])
    ['diverged', 'converged']
    """
    return catalogue.select(catalogue.find([Path(folder)]), where, sort)
