"""Hydra's and OmegaConf's many-line errors, said in one."""

import re
from collections.abc import Sequence

_OVERRIDE = re.compile(r"Could not override '(?P<key>[^']+)'")
_OPTION = re.compile(r"Could not find '(?P<group>.+)/(?P<option>[^/']*)'")
_REQUIRED = re.compile(r"You must specify '(?P<group>[^']+)'")
_CHOICES = re.compile(r"Available options(?: in '[^']*')?:\n(?P<list>(?:\t.*\n?)+)")


def condense(error: Exception, arguments: Sequence[str]) -> str:
    """One line for `error`: key, value, remedy; `arguments` are the command line's."""
    text = str(error)
    if found := _OVERRIDE.search(text):
        key = found["key"]
        return f"{_typed(key, arguments)}: unknown key; squat task=NAME --cfg job lists the keys"
    if found := _OPTION.search(text):
        return f"{found['group']}={found['option']}: unknown; give one of {_choices(text)}"
    if found := _REQUIRED.search(text):
        group = found["group"]
        return f"{group}: missing; give {group}=NAME, one of {_choices(text)}"
    lines = [line.strip() for line in text.splitlines() if line.strip()]
    kept = [line for line in lines if not re.match(r"(full_key|object_type|\^|See https)", line)]
    return "; ".join(kept) or type(error).__name__


def _typed(key: str, arguments: Sequence[str]) -> str:
    """The argument that set `key`, as it was typed."""
    name = key.split("@", maxsplit=1)[0]
    for argument in arguments:
        if argument.lstrip("+~").split("=")[0] in (key, name):
            return argument.lstrip("+~")
    return key


def _choices(text: str) -> str:
    found = _CHOICES.search(text)
    return ", ".join(found["list"].split()) if found else "those in conf/"
