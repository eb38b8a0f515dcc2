"""The piston in a U-tube: the coupled problem with an exact solution (section 2)."""

from squat.piston.case import PistonCase
from squat.piston.piston import Piston
from squat.piston.run import run
from squat.piston.study import PistonStudy, StudyCase, study

__all__ = ["Piston", "PistonCase", "PistonStudy", "StudyCase", "run", "study"]
