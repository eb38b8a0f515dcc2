"""What may be typed more simply than Hydra's grammar has it."""

from collections.abc import Sequence

from squat.config.quotes import quoted, quotes

LISTS = {"replay": "run"}
"""Tasks with a key whose value may be a list by commas."""
CONDITIONS = "where"
"""The key whose value is a condition: hardly one is a word of Hydra's grammar."""
_READ_BY_HYDRA = ("[", "'", '"')


def readable(arguments: Sequence[str]) -> list[str]:
    """`arguments` as Hydra reads them; a multirun's stay, where commas and quotes are Hydra's own.

    Such are `run=A,B` of task=replay, a list (Hydra has commas for the values of a multirun only),
    and a condition with the quotes that the shell has left: `where=status == 'diverged'`.
    """
    if {"-m", "--multirun"} & set(arguments):
        return list(arguments)
    tasks = [word.removeprefix("task=") for word in arguments if word.startswith("task=")]
    lists = {LISTS[task] for task in tasks if task in LISTS}
    return [_condition(_with_list(word, lists)) for word in arguments]


def _with_list(word: str, keys: set[str]) -> str:
    key, _, value = word.partition("=")
    if key not in keys or "," not in value or value.startswith(_READ_BY_HYDRA):
        return word
    return f"{key}=[{','.join(quoted(name) for name in value.split(','))}]"


def _condition(word: str) -> str:
    key, _, value = word.partition("=")
    return f"{key}={quoted(value)}" if key == CONDITIONS and value and not quotes(value) else word
