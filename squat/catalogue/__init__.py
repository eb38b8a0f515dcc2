"""All runs below a folder as one table: what they were, how they ended, what came out."""

from squat.catalogue.difference import DifferenceCase, write_difference
from squat.catalogue.find import RESULT, find, places
from squat.catalogue.headlines import units
from squat.catalogue.select import columns, select, varying
from squat.catalogue.task import CatalogueCase, write_catalogue

__all__ = [
    "RESULT",
    "CatalogueCase",
    "DifferenceCase",
    "columns",
    "find",
    "places",
    "select",
    "units",
    "varying",
    "write_catalogue",
    "write_difference",
]
