"""Helpers of the Snakefile: the same `compose()` as the command line, nothing numeric."""

import json
from functools import cache
from typing import Any

from squat.config import compose


@cache
def configured(task: str, *overrides: str) -> str:
    """Composed configuration of a task as JSON.

    Given to a rule as a parameter, it makes Snakemake run the rule again when, and only when,
    a value that the task depends on has changed.
    """
    return json.dumps(compose(task, *overrides), sort_keys=True)


def cases(group: str, choice: str) -> dict[str, list[Any]]:
    """A list of cases from `conf/cases/<group>/<choice>.yaml`."""
    found = compose("transient", f"+cases/{group}@cases={choice}")["cases"]
    assert isinstance(found, dict)
    return found
