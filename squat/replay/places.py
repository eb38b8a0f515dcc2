"""Where runs lie: files, or folders that hold one."""

from pathlib import Path

from squat.catalogue.find import find
from squat.errors import InputError
from squat.records.piston_kinds import PISTON
from squat.records.transient_kinds import TRANSIENT

MOVING = (TRANSIENT.name, PISTON.name)
"""Kinds of datasets that can be replayed."""


def file_of(place: Path) -> Path:
    """`place`, or the file of the one run in the folder that it is, searched to any depth.

    Raises
    ------
    InputError
        A folder that holds no run that can be replayed, or several.
    """
    if not place.is_dir():
        return place
    runs = _moving(place)
    if not runs:
        raise InputError(
            f"run={place}: is a folder without a run of squat task=transient or task=piston; "
            "give one with such a file"
        )
    if len(runs) > 1:
        raise InputError(
            f"run={place}: is a folder of {len(runs)} runs; "
            "give some of its .nc files, as run=A.nc,B.nc"
        )
    return runs[0]


def _moving(folder: Path) -> list[Path]:
    try:
        found = find([folder])
    except InputError:  # no run of any kind
        return []
    return [Path(name) for name in found.loc[found["kind"].isin(MOVING), "file"]]
