"""One function a figure; each draws from datasets alone."""

from squat.figures.compare import CompareCase, write_compare
from squat.figures.write import FigureCase, write_figure

__all__ = ["CompareCase", "FigureCase", "write_compare", "write_figure"]
