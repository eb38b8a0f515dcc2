"""Hydra's and OmegaConf's many-line errors in one line, for the command line and notebooks."""

import re
import shlex
from collections.abc import Sequence

from hydra.errors import OverrideParseException

from squat.config.near import near
from squat.config.quotes import quoted
from squat.errors import InputError

_CHOICES = re.compile(r"Available options(?: in '[^']*')?:\n(?P<list>(?:\t.*\n?)+)")
_NOISE = re.compile(r"(full_key|object_type|\^|See https|Set the environment)")
_KNOWN = {
    r"Could not (?:override|append|delete)[^']*'(?P<key>[^']+)'": (
        "{typed}: unknown key; {meant}squat task=NAME --cfg job lists the keys"
    ),
    r"Could not find '(?P<key>.+)/(?P<option>[^/']*)'": (
        "{key}={option}: unknown; give one of {choices}"
    ),
    r"In '(?P<file>[^']+)': Could not load '(?P<key>[^']+)'": (
        "{file}.yaml: defaults: {key}: unknown; give one of those in conf/"
    ),
    r"You must specify '(?P<key>[^']+)'": "{key}: missing; give {key}=NAME, one of {choices}",
    r"Missing mandatory value: (?P<key>\S+)": "{key}: missing; give {key}=VALUE",
    r"Ambiguous value for argument '(?P<key>.+)'\n": (
        "{key}: several values; give one, a list in brackets, or a run of each by squat -m"
    ),
}


_REPEATED = 100
"""Letters of an argument up to which a message shows it a second time, in quotes."""


def condense(error: Exception, arguments: Sequence[str]) -> str:
    """One line for `error`: key, value, remedy; `arguments` are what was typed."""
    text = str(error)
    if isinstance(error, InputError):
        return " ".join(text.split())
    if isinstance(error, OSError) and error.filename is not None:
        return f"{_short(error.filename)}: {error.strerror}; give another file or folder"
    if isinstance(error, OverrideParseException):
        return _unread(" ".join(str(error.override).split()))
    for pattern, line in _KNOWN.items():
        if found := re.search(pattern, text):
            names = found.groupdict()
            typed = _typed(names["key"], arguments)
            meant = _meant(names["key"], arguments) if "{meant}" in line else ""
            return line.format(**names, typed=typed, meant=meant, choices=_choices(text))
    lines = [line.strip() for line in text.splitlines() if line.strip()]
    kept = [line for line in lines if not _NOISE.match(line)]
    return f"{'; '.join(kept) or type(error).__name__} (in: {' '.join(arguments)})"


def _unread(typed: str) -> str:
    """What to say of an argument that is not of Hydra's grammar: how its value is quoted."""
    key, _, value = typed.partition("=")
    advice = f"{_short(typed)}: cannot be read; give KEY=VALUE"
    if not (key and value):
        return advice
    if value.startswith(("[", "{")):
        return f"{advice}, its brackets closed and its texts in quotes"
    whole = shlex.quote(f"{key}={quoted(value)}")
    shown = f": {whole}" if len(whole) <= _REPEATED else ""
    return f"{advice}, VALUE in quotes within those of the shell{shown}"


def _typed(key: str, arguments: Sequence[str]) -> str:
    """The argument that set `key`, as it was typed."""
    name = key.split("@", maxsplit=1)[0]
    for argument in arguments:
        if argument.lstrip("+~").split("=")[0] in (key, name):
            return argument.lstrip("+~")
    return key


def _meant(key: str, arguments: Sequence[str]) -> str:
    found = near(key, arguments)
    return f"did you mean {found!r}? " if found else ""


def _short(name: object) -> str:
    text = " ".join(str(name).split())
    return text if len(text) <= 300 else text[:297] + "..."


def _choices(text: str) -> str:
    found = _CHOICES.search(text)
    return ", ".join(found["list"].split()) if found else "those in conf/"
