"""One function a figure; each draws from datasets alone."""

from squat.figures.write import FigureCase, write_figure

__all__ = ["FigureCase", "write_figure"]
