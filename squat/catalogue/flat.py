"""A configuration as one row: nested keys under the dotted names that a command line takes."""

import json
from collections.abc import Mapping
from typing import Any

from squat.records.identity import HOUSEKEEPING
from squat.records.provenance import choices_of

_NOT_PHYSICS = ("task", *HOUSEKEEPING)
_FILES = ("inputs", "data", "runs", "tables", "transients", "pitching")
"""Groups and keys that hold paths: where a run got its files says nothing about its result."""


def row_of(attributes: Mapping[str, Any]) -> dict[str, Any]:
    """Choices by their groups, then the configuration; a key of a group's name is itself."""
    return {**choices_of(attributes), **flatten(json.loads(attributes["config"]))}


def flatten(config: Mapping[str, Any]) -> dict[str, Any]:
    """Values of `config` under dotted keys; lists become JSON text, so that rows compare."""
    return {
        key: value
        for key, value in _leaves(config, "")
        if key not in _NOT_PHYSICS and key.split(".")[0] not in _FILES
    }


def _leaves(node: Mapping[str, Any], prefix: str) -> list[tuple[str, Any]]:
    found: list[tuple[str, Any]] = []
    for key, value in node.items():
        if isinstance(value, Mapping):
            found += _leaves(value, f"{prefix}{key}.")
        else:
            plain = json.dumps(value) if isinstance(value, list) else value
            found.append((f"{prefix}{key}", plain))
    return found
