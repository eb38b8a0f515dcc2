"""Helpers of the Snakefile: the same `compose()` as the command line, nothing numeric."""

import json
from typing import Any

from workflows.composed import Composed

_composed = Composed()


def configured(task: str, *overrides: str) -> str:
    """Composed configuration of a task as JSON.

    Given to a rule as a parameter, it makes Snakemake run the rule again when, and only when,
    a value that the task depends on has changed.
    """
    return json.dumps(_composed(task, *overrides), sort_keys=True)


def cases(group: str, choice: str) -> dict[str, list[Any]]:
    """A list of cases from `conf/cases/<group>/<choice>.yaml`."""
    found = _composed("transient", f"+cases/{group}@cases={choice}")["cases"]
    assert isinstance(found, dict)
    return found
