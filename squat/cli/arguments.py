"""What may be typed more simply than Hydra's grammar has it."""

from collections.abc import Sequence
from contextlib import suppress
from pathlib import Path

from hydra.core.override_parser.overrides_parser import OverridesParser
from hydra.errors import HydraException

from squat.config.quotes import quoted, quotes

LISTS = {"replay": "run"}
"""Tasks with a key whose value may be a list by commas."""
CONDITIONS = "where"
"""The key whose value is a condition: hardly one is a word of Hydra's grammar."""
_READ_BY_HYDRA = ("[", "'", '"')


def readable(arguments: Sequence[str]) -> list[str]:
    """`arguments` as Hydra reads them.

    `run=A,B` of task=replay becomes a list (Hydra has commas for the values of a multirun only),
    and a condition gets the quotes that the shell took: `where=status == 'diverged'`. Commas and
    quotes of a multirun stay, which are Hydra's own; a key of a swept choice becomes a sweep.
    """
    if {"-m", "--multirun"} & set(arguments):
        return _of_swept(arguments)
    tasks = [word.removeprefix("task=") for word in arguments if word.startswith("task=")]
    lists = {LISTS[task] for task in tasks if task in LISTS}
    return [_condition(_with_list(word, lists)) for word in arguments]


def _of_swept(arguments: Sequence[str]) -> list[str]:
    """`hull=A,B hull.segments=30` with the last as a sweep over one value.

    What is no sweep Hydra tries on the choices that are made if nothing is chosen: the key may be
    unknown there, though both A and B have it. (Of null Hydra can make no sweep.)
    """
    parser = OverridesParser.create()
    parsed = {}
    for word in arguments:
        with suppress(HydraException):  # an option, or what Hydra itself will refuse
            parsed[word] = parser.parse_override(word)
    swept = {one.package or one.key_or_group for one in parsed.values() if one.is_sweep_override()}
    within = [
        word
        for word, one in parsed.items()
        if not (one.is_sweep_override() or one.is_delete() or one.value() is None)
        and any(one.key_or_group.startswith(f"{group}.") for group in swept)
    ]
    return [_swept(word) if word in within else word for word in arguments]


def _swept(word: str) -> str:
    key, _, value = word.partition("=")
    return f"{key}=choice({value})"


def _with_list(word: str, keys: set[str]) -> str:
    key, _, value = word.partition("=")
    if key not in keys or "," not in value or value.startswith(_READ_BY_HYDRA):
        return word
    return f"{key}=[{','.join(quoted(name) for name in _files(value.split(',')))}]"


def _files(pieces: Sequence[str]) -> list[str]:
    """Names of files that `pieces` between commas make: a name may hold some itself."""
    names, rest = [], list(pieces)
    while rest:
        joined = (",".join(rest[:count]) for count in range(1, len(rest) + 1))
        names.append(next((name for name in joined if Path(name).exists()), rest[0]))
        rest = rest[names[-1].count(",") + 1 :]
    return names


def _condition(word: str) -> str:
    key, _, value = word.partition("=")
    return f"{key}={quoted(value)}" if key == CONDITIONS and value and not quotes(value) else word
