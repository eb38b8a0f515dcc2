"""Composed configurations, kept between starts of Snakemake: a fifth of a second each."""

import hashlib
import json
from contextlib import suppress
from importlib.metadata import version
from pathlib import Path
from pkgutil import resolve_name
from typing import Any

from squat.errors import InputError

ROOT = Path(__file__).parents[1]
STORE = Path(".snakemake/squat/composed.json")


class Composed:
    """`squat.config.compose`, its answers kept in `store` until `conf/`, squat or Hydra change."""

    def __init__(self, store: Path = STORE, root: Path = ROOT):
        self._store, self._source = store, source(root)
        self._answers: dict[str, dict[str, Any]] = {}
        with suppress(OSError, ValueError, KeyError, TypeError):  # none there, or no longer whole
            kept = json.loads(store.read_text(encoding="utf-8"))
            if kept["source"] == self._source:
                self._answers = dict(kept["answers"])

    def __call__(self, task: str, *overrides: str) -> dict[str, Any]:
        """Configuration of `squat task=<task> <overrides>`."""
        words = json.dumps([task, *overrides])
        if words not in self._answers:
            self._answers[words] = resolve_name("squat.config:compose")(task, *overrides)
            self._keep()
        return self._answers[words]

    def _keep(self) -> None:
        """Write all answers; a folder that cannot be written costs time, and no more."""
        text = json.dumps({"source": self._source, "answers": self._answers})
        atomic = resolve_name("squat.records:atomic")
        with suppress(InputError), atomic(self._store) as temporary:
            temporary.write_text(text, encoding="utf-8")


def source(root: Path) -> str:
    """Digest of all that an answer depends on: the files of `conf/` and squat, Hydra's version."""
    found = hashlib.sha256(version("hydra-core").encode())
    for path in sorted([*root.glob("conf/**/*.yaml"), *root.glob("squat/**/*.py")]):
        found.update(f"{path.relative_to(root)}\n{path.stat().st_size}\n".encode())
        found.update(path.read_bytes())
    return found.hexdigest()
