"""Dynamic ship squat, and the added-mass effect in partitioned fluid-structure coupling."""

from importlib.metadata import version

__version__ = version("squat")
