"""The hull and the channel that it moves in: frozen, checked geometry."""

from squat.channel.channel import Channel, check_afloat
from squat.channel.hull import Hull

__all__ = ["Channel", "Hull", "check_afloat"]
