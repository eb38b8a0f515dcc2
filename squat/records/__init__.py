"""Datasets on disk: self-describing, written whole or not at all, checked when read."""

from squat.records.files import (
    groups,
    read,
    read_group,
    read_whole,
    save,
    save_table,
    stamp,
)
from squat.records.identity import identity, is_answer, strict_identity
from squat.records.inputs import read_input
from squat.records.kinds import KINDS
from squat.records.provenance import choices_of, config_of, plain
from squat.records.schema import Kind, Variable, build
from squat.records.segments import Segments
from squat.records.writing import BusyError, atomic, claim

__all__ = [
    "KINDS",
    "BusyError",
    "Kind",
    "Segments",
    "Variable",
    "atomic",
    "build",
    "choices_of",
    "claim",
    "config_of",
    "groups",
    "identity",
    "is_answer",
    "plain",
    "read",
    "read_group",
    "read_input",
    "read_whole",
    "save",
    "save_table",
    "stamp",
    "strict_identity",
]
