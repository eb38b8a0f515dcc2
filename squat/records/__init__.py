"""Datasets on disk: self-describing, written whole or not at all, checked when read."""

from squat.records.files import atomic, read, save
from squat.records.kinds import KINDS
from squat.records.schema import Kind, Variable, build

__all__ = ["KINDS", "Kind", "Variable", "atomic", "build", "read", "save"]
