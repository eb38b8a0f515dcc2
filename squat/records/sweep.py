"""The kind of a joined sweep: another kind's variables over the swept parameters."""

import json
from collections.abc import Mapping, Sequence
from typing import Any

import xarray as xr

from squat.errors import InputError
from squat.records.schema import Kind, Variable

INDEX = "_index"
"""Ends the name of a dimension whose coordinate differs from job to job."""
_JOB = {
    "job_status": "how the job's run ended; failed: bad input; missing: no dataset",
    "job_name": "the job's folder or file; empty where no job was planned",
    "job_failure": "why the job has no dataset; empty where it has",
}


class SweepKind(Kind):
    """Checks a sweep against the kind that was joined; swept parameters come first, in any number.

    A variable of the kind has the sweep's dimensions before its own, a coordinate need not.
    """

    def check(self, dataset: xr.Dataset, where: str) -> None:
        """Raise InputError, naming `where`, unless `dataset` is a sweep of a known kind."""
        for name in self.attributes:
            if name not in dataset.attrs:
                raise InputError(f"{where}: attribute {name!r} is missing; {self._remedy}")
        axes = tuple(json.loads(dataset.attrs["axes"]))
        for name in _JOB:
            _check_one(dataset, name, [axes], "1", where)
        source: Mapping[str, list[Any]] = json.loads(dataset.attrs["joined"])["variables"]
        for name, (dims, units) in source.items():
            own = tuple(dims)
            _check_one(dataset, name, [axes + own, own], units, where)


def _check_one(
    dataset: xr.Dataset, name: str, dims: Sequence[tuple[str, ...]], units: str, where: str
) -> None:
    found = dataset.variables.get(name)
    if found is None or found.dims not in dims or found.attrs.get("units") != units:
        raise InputError(f"{where}: {name!r} is not what was joined; write it again")


SWEEP = SweepKind(
    "sweep",
    1,
    "The datasets of a multirun over its swept parameters",
    {name: Variable(("...",), "1", meaning) for name, meaning in _JOB.items()},
    ("joined", "axes", "failed", "missing", "common_config"),
)


def joined_kind(variables: Mapping[str, Variable], axes: Mapping[str, str]) -> SweepKind:
    """Kind of one sweep: `variables` as they will be, and `axes`, dotted key by dimension."""
    lead = tuple(axes)
    parameters = {name: Variable((name,), "1", f"swept: {key}") for name, key in axes.items()}
    jobs = {name: Variable(lead, "1", meaning) for name, meaning in _JOB.items()}
    everything = {**parameters, **variables, **jobs}
    return SweepKind(SWEEP.name, SWEEP.version, SWEEP.title, everything, SWEEP.attributes)
