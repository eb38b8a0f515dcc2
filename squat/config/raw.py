"""What Hydra makes of `conf/` and overrides; its errors are its own here."""

from collections.abc import Sequence
from contextlib import nullcontext
from pathlib import Path
from typing import Any

from hydra import compose, initialize_config_dir
from hydra.core.global_hydra import GlobalHydra
from omegaconf import DictConfig, OmegaConf

import squat


def _conf() -> Path:
    """`conf/` of the installed package, or of the source tree."""
    package = Path(squat.__file__).parent
    inside = package / "conf"
    return inside if inside.is_dir() else package.parent / "conf"


CONF = _conf()


def composed(words: Sequence[str]) -> DictConfig:
    """Configuration of `squat <words>`, nothing in it resolved or checked."""
    within = GlobalHydra.instance().is_initialized()  # the command line's own Hydra
    with nullcontext() if within else initialize_config_dir(str(CONF), version_base="1.3"):
        return compose("config", list(words))


def plain(config: DictConfig) -> dict[str, Any]:
    """Resolved plain containers: equal configurations compare and print equal."""
    container = OmegaConf.to_container(config, resolve=True, throw_on_missing=True)
    assert isinstance(container, dict)
    return {str(key): value for key, value in container.items()}
