"""Compose a configuration from `conf/` and overrides."""

from collections.abc import Mapping
from contextlib import nullcontext
from pathlib import Path
from typing import Any, NamedTuple

from hydra import compose as hydra_compose
from hydra import initialize_config_dir
from hydra.core.global_hydra import GlobalHydra
from hydra.errors import HydraException
from omegaconf import DictConfig, OmegaConf, open_dict
from omegaconf.errors import OmegaConfBaseException

import squat
from squat.config.messages import condense
from squat.errors import InputError


def _conf() -> Path:
    """`conf/` of the installed package, or of the source tree."""
    package = Path(squat.__file__).parent
    inside = package / "conf"
    return inside if inside.is_dir() else package.parent / "conf"


CONF = _conf()


class Composed(NamedTuple):
    """A resolved configuration, and the choice of each group of `conf/` that it is made of."""

    config: dict[str, Any]
    choices: dict[str, str]


def plain(config: DictConfig) -> dict[str, Any]:
    """Resolved plain containers: equal configurations compare and print equal."""
    container = OmegaConf.to_container(config, resolve=True, throw_on_missing=True)
    assert isinstance(container, dict)
    return {str(key): value for key, value in container.items()}


def plain_choices(chosen: Mapping[str, Any]) -> dict[str, str]:
    """Of what Hydra has `chosen`, the groups whose name is their key: `hull`, `mesh`, ...

    Left out are the task, Hydra's own groups, and those put elsewhere (`hull@hulls.mine`).
    """
    return {
        group: choice
        for group, choice in chosen.items()
        if not {"@", "/"}.intersection(group) and group != "task" and isinstance(choice, str)
    }


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
    within = GlobalHydra.instance().is_initialized()  # the command line's own Hydra
    with nullcontext() if within else initialize_config_dir(str(CONF), version_base="1.3"):
        try:
            found = hydra_compose("config", words, return_hydra_config=True)
            choices = plain_choices(found.hydra.runtime.choices)
            with open_dict(found):
                del found["hydra"]
            return Composed(plain(found), choices)
        except (HydraException, OmegaConfBaseException, ValueError) as error:
            raise InputError(condense(error, words)) from None
