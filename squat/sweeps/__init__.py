"""Multiruns as a whole: which jobs they have, and their datasets joined into one."""

from squat.sweeps.collect import CollectCase, collect
from squat.sweeps.jobs import FAILED, write_plan

__all__ = ["FAILED", "CollectCase", "collect", "write_plan"]
