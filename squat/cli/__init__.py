"""The command `squat`."""

from squat.cli.main import main

__all__ = ["main"]
