"""The key that was meant by one that does not exist."""

import difflib
from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from hydra.errors import HydraException
from omegaconf import OmegaConf
from omegaconf.errors import OmegaConfBaseException

from squat.config.raw import merged


def near(key: str, arguments: Sequence[str]) -> str:
    """The dotted key of the configuration that is most like `key`; empty: none is.

    The keys are those of `arguments` without `key`, or of their task alone where others of them
    are wrong as well.
    """
    words = [word for word in arguments if "=" in word and not word.startswith(("-", "hydra"))]
    others = [word for word in words if word.lstrip("+~").partition("=")[0] != key]
    for tried in (others, [word for word in words if word.startswith("task=")]):
        try:
            config = OmegaConf.to_container(merged(tried).config)
        except (HydraException, OmegaConfBaseException, ValueError):
            continue
        return next(iter(difflib.get_close_matches(key, list(_keys(config)), n=1)), "")
    return ""


def _keys(config: Any, prefix: str = "") -> Iterator[str]:
    if isinstance(config, Mapping):
        for key, value in config.items():
            yield f"{prefix}{key}"
            yield from _keys(value, f"{prefix}{key}.")
