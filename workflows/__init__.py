"""Helpers of the graph; not part of the package."""
