"""A drawn figure as files."""

from pathlib import Path

from matplotlib.figure import Figure

from squat import records


def save(figure: Figure, path: Path) -> None:
    """Write `figure` to `path` (.png) and beside it as .svg, each whole or not at all."""
    for target in (path, path.with_suffix(".svg")):
        metadata = {"Date": None} if target.suffix == ".svg" else None
        with records.atomic(target) as temporary:
            figure.savefig(temporary, metadata=metadata)
        figure.set_layout_engine(None)  # laid out: the next has everything in the same places
