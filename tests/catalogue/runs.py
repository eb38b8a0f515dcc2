"""Of the runs in `conftest.py`."""

RATIOS = (0.5, 2.0, 0.9)  # mass ratios
