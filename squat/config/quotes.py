"""Quotes of Hydra's grammar."""

import re

_QUOTED = re.compile(r"""'(?:[^'\\]|\\.)*'|"(?:[^"\\]|\\.)*\"""", re.DOTALL)
_END = re.compile(r'(\\*)("|\Z)')


def quotes(value: str) -> bool:
    """Whether `value` is one text in quotes, and nothing else."""
    return _QUOTED.fullmatch(value) is not None


def quoted(value: str) -> str:
    """`value` in quotes; backslashes mean themselves in there, but before a quote."""
    return '"' + _END.sub(lambda end: end[1] * 2 + ('\\"' if end[2] else ""), value) + '"'
