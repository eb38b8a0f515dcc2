"""Replays: recordings for the rerun viewer, derived from datasets alone.

`squat.replay.write` imports rerun, which takes a second: import it where it is used.
"""

from squat.replay.case import ReplayCase

__all__ = ["ReplayCase"]
