"""Compose a configuration from `conf/` and overrides."""

from typing import Any

from hydra.errors import HydraException
from omegaconf.errors import OmegaConfBaseException

from squat.config.messages import condense
from squat.config.raw import composed, plain
from squat.errors import InputError


def compose(task: str, *overrides: str) -> dict[str, Any]:
    """Configuration of `squat task=<task> <overrides>` as plain containers, values not checked.

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
        return plain(composed(words))
    except (HydraException, OmegaConfBaseException, ValueError) as error:
        raise InputError(condense(error, words)) from None
