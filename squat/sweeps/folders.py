"""Names of the folders of a sweep's jobs."""

import hashlib
import re

_MOST = 200
"""Bytes of a folder's name: file systems take 255, and some of them fewer."""
_DIGITS = 12


def job_folder(overrides: str) -> str:
    """The folder of a job that is told apart by its `overrides`, Hydra's `override_dirname`.

    A name that is too long for a file system is cut, and ends in a digest of all of it.
    """
    return "/".join(map(_short, overrides.split("/")))


def _short(name: str) -> str:
    whole = name.encode()
    if len(whole) <= _MOST:
        return name
    digest = hashlib.sha256(whole).hexdigest()[:_DIGITS]
    return f"{whole[: _MOST - _DIGITS - 1].decode(errors='ignore')}-{digest}"


def was_cut(name: str) -> bool:
    """Whether the end of folder `name` is a digest, so that it does not tell what is in it."""
    cut = len(name.encode()) > _MOST - 4  # a letter that is cut in two is left out
    return cut and re.search(rf"-[0-9a-f]{{{_DIGITS}}}$", name) is not None
