"""Bring your own solver: a structure and any force, coupled by the same loop as the ship."""

from squat.external.run import couple
from squat.external.structure import Structure, StructureModel

__all__ = ["Structure", "StructureModel", "couple"]
