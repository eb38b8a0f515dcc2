"""From `conf/` to checked cases: the same way for the shell, the graph and the tests."""

from squat.config.compose import compose, composed
from squat.config.raw import CONF
from squat.config.schema import CASES, Settings, validate

__all__ = ["CASES", "CONF", "Settings", "compose", "composed", "validate"]
