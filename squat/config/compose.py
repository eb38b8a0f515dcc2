"""Compose a configuration from `conf/` and overrides."""

from contextlib import nullcontext
from pathlib import Path
from typing import Any

from hydra import compose as hydra_compose
from hydra import initialize_config_dir
from hydra.core.global_hydra import GlobalHydra
from hydra.errors import HydraException
from omegaconf import DictConfig, OmegaConf
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


def plain(config: DictConfig) -> dict[str, Any]:
    """Resolved plain containers: equal configurations compare and print equal."""
    container = OmegaConf.to_container(config, resolve=True, throw_on_missing=True)
    assert isinstance(container, dict)
    return {str(key): value for key, value in container.items()}


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
    within = GlobalHydra.instance().is_initialized()  # the command line's own Hydra
    with nullcontext() if within else initialize_config_dir(str(CONF), version_base="1.3"):
        try:
            return plain(hydra_compose("config", words))
        except (HydraException, OmegaConfBaseException, ValueError) as error:
            raise InputError(condense(error, words)) from None
