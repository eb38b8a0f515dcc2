"""The coupled run of ship and water: Algorithm 2 and its kin."""

from squat.transient.case import TransientCase
from squat.transient.run import Result, run

__all__ = ["Result", "TransientCase", "run"]
