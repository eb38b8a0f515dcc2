"""What a configuration may have Hydra make: squat's own callback, and Hydra's launchers.

Hydra calls what `_target_` names, and Python's logging what `()` and `class` name. A configuration
is data: whatever else it names is refused before anything is made of it.
"""

import re
from collections.abc import Iterator, Mapping
from typing import Any

from hydra._internal.config_loader_impl import ConfigLoaderImpl
from omegaconf import DictConfig, OmegaConf

from squat.errors import InputError

_TARGET = re.compile(
    r"squat\.cli\.jobs\.Jobs|hydra_plugins\.squat_batches\.(launcher\.Batches|cores\.Cores)"
    r"|(hydra_plugins|hydra\._internal\.core_plugins)(\.[a-z_]+)+\.[A-Za-z]+(Launcher|Sweeper)"
)
_LOGGING = re.compile(r"logging\.(handlers\.)?[A-Za-z]+(Handler|Formatter|Filter)")
_load = ConfigLoaderImpl.load_configuration


def guard() -> None:
    """Have every configuration that Hydra composes checked before it is used."""
    ConfigLoaderImpl.load_configuration = _checked  # type: ignore[method-assign]


def _checked(self: ConfigLoaderImpl, *args: Any, **kwargs: Any) -> DictConfig:
    config = _load(self, *args, **kwargs)
    plain = OmegaConf.to_container(config, resolve=False)
    for path, key, value in _named(plain):
        allowed = {"_target_": _TARGET, "class": _LOGGING}.get(key)
        if allowed is None or not allowed.fullmatch(str(value)):
            raise InputError(f"{path}={value}: not one of squat's; leave it out")
    return config


def _named(value: Any, path: str = "") -> Iterator[tuple[str, str, Any]]:
    """Path, key and value of all that names something to call, in nested containers."""
    if isinstance(value, Mapping):
        for key, inner in value.items():
            here = f"{path}.{key}" if path else str(key)
            if key == "_target_" or (key in ("()", "class") and path.startswith("hydra.")):
                yield here, str(key), inner
            yield from _named(inner, here)
    elif isinstance(value, list):
        for inner in value:
            yield from _named(inner, path)
