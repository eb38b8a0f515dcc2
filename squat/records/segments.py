"""A long run on disk, stretch by stretch: what a restart goes on from.

A segment is one file, renamed into place when it is whole. It is named by its first step and holds
the step that it leads to, so segments form a chain from step 0.
"""

import hashlib
import json
import logging
import shutil
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from squat.records.identity import difference
from squat.records.trees import Leaf, flatten, rebuild
from squat.records.writing import atomic

_log = logging.getLogger(__name__)


class Segment(NamedTuple):
    """The step that a segment leads to, and what it holds."""

    end: int
    content: Any


@dataclass(frozen=True)
class Segments:
    """The segments of one run in a folder of their own.

    Parameters
    ----------
    folder
        `<out>.parts`, beside the dataset to come.
    make
        `strict_identity` of the run: segments of any other are set aside, and are found again there
        by the run that they belong to.
    """

    folder: Path
    make: Mapping[str, Any]

    @staticmethod
    def beside(path: Path, make: Mapping[str, Any]) -> "Segments":
        """Segments of the run that will write `path`."""
        return Segments(path.with_name(path.name + ".parts"), make)

    @property
    def out(self) -> Path:
        """What the run will write."""
        return self.folder.with_suffix("")

    def write(self, begin: int, end: int, content: Any) -> None:
        """Keep `content` of the steps after `begin` up to `end`; InputError where it cannot be."""
        structure, leaves = flatten(content)
        header = json.dumps({"make": self.make, "end": end, "structure": structure})
        arrays: dict[str, Any] = {f"leaf{i}": leaf for i, leaf in enumerate(leaves)}
        with atomic(self._path(begin)) as temporary, temporary.open("wb") as file:
            np.savez(file, header=header, digest=_digest(header, leaves), **arrays)

    def read(self) -> Iterator[Segment]:
        """Segments of this run from its start, up to the first that is absent or broken."""
        self._settle()
        step = 0
        while (path := self._path(step)).is_file():
            try:
                segment = self._load(path)
            except Exception as error:  # whatever a damaged file makes its reader say
                _log.warning("%s: broken (%s); going on without it", path, error)
                return
            yield segment
            step = segment.end

    def clear(self) -> None:
        """Remove the folder: the run is over, or to be done again."""
        shutil.rmtree(self.folder, ignore_errors=True)

    def _settle(self) -> None:
        """Set segments of another run aside, with a warning, and bring back those of this one."""
        make, found = _plain(self.make), self._found()
        if found is not None and found != make:
            aside = self._aside(found)
            shutil.rmtree(aside, ignore_errors=True)
            self.folder.rename(aside)
            told = "%s: left by another run (%s); kept as %s for that one, starting again"
            _log.warning(told, self.folder, difference(make, found), aside.name)
        own = self._aside(make)
        if own.is_dir() and not self._path(0).is_file():
            self.clear()
            own.rename(self.folder)

    def _found(self) -> Any:
        """`make` of the run whose first segment is in the folder; None where nobody can tell."""
        try:
            with self._path(0).open("rb") as handle, np.load(handle, allow_pickle=False) as file:
                return json.loads(str(file["header"]))["make"]
        except Exception:  # absent, or whatever a damaged file makes its reader say
            return None

    def _aside(self, make: Any) -> Path:
        """Where segments of the run of that `make` are kept while another is at work."""
        digest = hashlib.sha256(json.dumps(make).encode()).hexdigest()[:8]
        return self.folder.with_name(f"{self.folder.name}.{digest}")

    def _path(self, begin: int) -> Path:
        return self.folder / f"{begin:09d}.npz"

    def _load(self, path: Path) -> Segment:
        with path.open("rb") as handle, np.load(handle, allow_pickle=False) as file:
            text = str(file["header"])
            leaves = [file[f"leaf{i}"] for i in range(len(file.files) - 2)]
            if str(file["digest"]) != _digest(text, leaves):
                raise ValueError("its digest is wrong")
        header = json.loads(text)
        if header["make"] != _plain(self.make):
            raise ValueError("of another run")
        return Segment(header["end"], rebuild(header["structure"], leaves))


def _plain(make: Any) -> Any:
    """As JSON gives it back."""
    return json.loads(json.dumps(make))


def _digest(header: str, leaves: list[Leaf]) -> str:
    total = hashlib.sha256(header.encode())
    for leaf in leaves:
        total.update(repr((leaf.dtype.str, leaf.shape)).encode())
        total.update(leaf.tobytes())
    return total.hexdigest()
