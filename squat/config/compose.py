"""Compose a configuration from `conf/` and overrides."""

from typing import Any, NamedTuple

from hydra.errors import HydraException
from omegaconf.errors import OmegaConfBaseException

from squat.config.messages import condense
from squat.config.raw import merged, plain
from squat.errors import InputError


class Composed(NamedTuple):
    """A resolved configuration, and the choice of each group of `conf/` that it is made of."""

    config: dict[str, Any]
    choices: dict[str, str]


def compose(task: str, *overrides: str) -> dict[str, Any]:
    """Configuration of `squat task=<task> <overrides>` as plain containers, values not checked.

    Raises InputError as `composed` does.
    """
    return composed(task, *overrides).config


def composed(task: str, *overrides: str) -> Composed:
    """Configuration of `squat task=<task> <overrides>`, values not checked, with its choices.

    Raises
    ------
    InputError
        One line, worded as on the command line: a key or a choice that is not there.
    """
    for word in overrides:
        if not isinstance(word, str) or word.lstrip("+~").startswith("task="):
            raise InputError(f"{word}: not an override; give 'KEY=VALUE', the task apart")
    words = [f"task={task}", *overrides]
    try:
        found = merged(words)
        return Composed(plain(found.config), found.choices)
    except (HydraException, OmegaConfBaseException, ValueError) as error:
        raise InputError(condense(error, words)) from None
