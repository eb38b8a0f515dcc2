"""The key that was meant by one that does not exist."""

import difflib
from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from hydra.errors import HydraException
from omegaconf import OmegaConf
from omegaconf.errors import OmegaConfBaseException

from squat.config.raw import merged

_CALLED = {
    **dict.fromkeys(("speed", "velocity", "v", "v_inf"), "current"),
    **dict.fromkeys(("h", "water_depth"), "channel.depth"),
    **dict.fromkeys(("heave", "w", "w0", "sinkage"), "initial_heave"),
    **dict.fromkeys(("pitch", "trim"), "initial_pitch"),
    "t": "hull.draft",
    "l": "hull.length",
    "rho": "water.density",
    "g": "water.gravity",
}
"""Keys by what others call them: words and symbols of the field."""


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
        return _likest(key, list(_keys(config)))
    return ""


def _likest(key: str, keys: list[str]) -> str:
    """What the field calls so, else the key whose name or end is spelt most like it."""
    meant = _CALLED.get(key.lower())
    if meant in keys:
        return meant
    spelt = {one.rpartition(".")[2]: one for one in reversed(keys)} | {one: one for one in keys}
    return next((spelt[one] for one in difflib.get_close_matches(key, spelt, n=1)), "")


def _keys(config: Any, prefix: str = "") -> Iterator[str]:
    if isinstance(config, Mapping):
        for key, value in config.items():
            yield f"{prefix}{key}"
            yield from _keys(value, f"{prefix}{key}.")
