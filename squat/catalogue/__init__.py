"""All runs below a folder as one table: what they were, how they ended, what came out."""

from squat.catalogue.difference import DifferenceCase, write_difference
from squat.catalogue.find import RESULT, find, places
from squat.catalogue.headlines import units
from squat.catalogue.select import (
    OWN_NAMES,
    columns,
    implies,
    independent,
    meant,
    parts,
    select,
    varying,
)
from squat.catalogue.task import CatalogueCase, write_catalogue

__all__ = [
    "OWN_NAMES",
    "RESULT",
    "CatalogueCase",
    "DifferenceCase",
    "columns",
    "find",
    "implies",
    "independent",
    "meant",
    "parts",
    "places",
    "select",
    "units",
    "varying",
    "write_catalogue",
    "write_difference",
]
