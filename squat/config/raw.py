"""What Hydra makes of `conf/` and overrides; its errors are its own here."""

from collections.abc import Mapping, Sequence
from contextlib import nullcontext
from pathlib import Path
from typing import Any, NamedTuple

from hydra import compose, initialize_config_dir
from hydra.core.global_hydra import GlobalHydra
from omegaconf import DictConfig, OmegaConf, open_dict

import squat
from squat.sweeps.folders import job_folder

OmegaConf.register_new_resolver("job_folder", job_folder, replace=True)


def _conf() -> Path:
    """`conf/` of the installed package, or of the source tree."""
    package = Path(squat.__file__).parent
    inside = package / "conf"
    return inside if inside.is_dir() else package.parent / "conf"


CONF = _conf()


class Merged(NamedTuple):
    """A configuration, nothing in it resolved, and the choice of each group that it is made of."""

    config: DictConfig
    choices: dict[str, str]


def merged(words: Sequence[str]) -> Merged:
    """Configuration of `squat <words>`, nothing in it checked."""
    within = GlobalHydra.instance().is_initialized()  # the command line's own Hydra
    with nullcontext() if within else initialize_config_dir(str(CONF), version_base="1.3"):
        found = compose("config", list(words), return_hydra_config=True)
    choices = plain_choices(found.hydra.runtime.choices)
    with open_dict(found):
        del found["hydra"]
    return Merged(found, choices)


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
