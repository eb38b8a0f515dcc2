"""Which files below a folder of results a report is of."""

from collections.abc import Sequence
from pathlib import Path

from squat.catalogue.find import files


class Members:
    """The files below `results` that belong to the report.

    In the folder of each of the `given` files, only those that are given do: what else lies there
    is of another configuration, which came before. All other folders belong as a whole.
    """

    def __init__(self, results: Path, given: Sequence[str]) -> None:
        self.results = results
        self._given = {Path(name).resolve() for name in given}
        self._chosen = {path.parent for path in self._given}

    @property
    def datasets(self) -> list[Path]:
        """NetCDF files that belong."""
        return [path for path in files([self.results]) if self._belongs(path)]

    @property
    def strangers(self) -> list[str]:
        """NetCDF files that do not, by their names below the results."""
        return [self.name(path) for path in files([self.results]) if not self._belongs(path)]

    def like(self, pattern: str) -> list[str]:
        """Names of the files that belong and that `pattern` fits."""
        return sorted(map(self.name, filter(self._belongs, self.results.glob(pattern))))

    def name(self, path: Path) -> str:
        """Name below the results."""
        return path.relative_to(self.results).as_posix()

    def _belongs(self, path: Path) -> bool:
        whole = path.resolve()
        return whole in self._given or whole.parent not in self._chosen
