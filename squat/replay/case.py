"""What to replay."""

from typing import Annotated

from pydantic import Field
from pydantic.dataclasses import dataclass

from squat.errors import InputError
from squat.quantities import STRICT


@dataclass(frozen=True, kw_only=True, config=STRICT)
class ReplayCase:
    """Runs to show in one recording.

    Parameters
    ----------
    run
        Dataset of task=transient or task=piston, or a folder that holds one; several of one task
        to compare.
    """

    run: str | Annotated[tuple[str, ...], Field(min_length=1)]

    def __post_init__(self) -> None:
        for name in self.files:
            if not name:
                raise InputError(f"run={','.join(self.files)}: an empty name; give run=A.nc,B.nc")
            if self.files.count(name) > 1:
                raise InputError(f"run={','.join(self.files)}: {name} twice; give each run once")

    @property
    def files(self) -> tuple[str, ...]:
        """Paths of the runs, the reference of differences first."""
        return (self.run,) if isinstance(self.run, str) else self.run
