"""What may be typed more simply than Hydra's grammar has it."""

from collections.abc import Sequence

LISTS = {"replay": "run"}
"""Tasks with a key whose value may be a list by commas."""
_READ_BY_HYDRA = ("[", "'", '"')


def with_lists(arguments: Sequence[str]) -> list[str]:
    """`arguments` with `run=A,B` of task=replay as Hydra reads a list; a multirun's stay.

    Hydra has commas for the values of a multirun only, and refuses them elsewhere.
    """
    if {"-m", "--multirun"} & set(arguments):
        return list(arguments)
    tasks = [word.removeprefix("task=") for word in arguments if word.startswith("task=")]
    return [
        _with_list(word, {LISTS[task] for task in tasks if task in LISTS}) for word in arguments
    ]


def _with_list(word: str, keys: set[str]) -> str:
    key, _, value = word.partition("=")
    if key not in keys or "," not in value or value.startswith(_READ_BY_HYDRA):
        return word
    quoted = [
        '"' + name.replace("\\", "\\\\").replace('"', '\\"') + '"' for name in value.split(",")
    ]
    return f"{key}=[{','.join(quoted)}]"
