"""Datasets on disk: self-describing, written whole or not at all, checked when read."""

from squat.records.files import atomic, read, read_group, save
from squat.records.kinds import KINDS
from squat.records.provenance import config_of, plain
from squat.records.schema import Kind, Variable, build

__all__ = [
    "KINDS",
    "Kind",
    "Variable",
    "atomic",
    "build",
    "config_of",
    "plain",
    "read",
    "read_group",
    "save",
]
