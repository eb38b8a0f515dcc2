"""Runs against what is printed: tables and verdicts."""

from squat.analysis.tables import TableCase, write_table
from squat.analysis.verdicts import VerdictsCase, write_verdicts

__all__ = ["TableCase", "VerdictsCase", "write_table", "write_verdicts"]
