"""The race: iterations of every scheme with every accelerator, on piston and ship."""

from squat.race.case import RaceCase
from squat.race.run import run

__all__ = ["RaceCase", "run"]
