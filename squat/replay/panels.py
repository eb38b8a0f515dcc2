"""The register of panels: what a recording shows follows from what the records hold.

A panel is a function of recorder and runs that sends its entities and returns its views:

    @panel("portrait", Place.PROFILE, needs=("heave", "heave_velocity"))
    def portrait(recorder, runs):
        ...
        return [rrb.Spatial2DView(...)]

It is called with those runs whose records hold all of `needs`, if there are any; a module of
panels is imported by `squat.replay.write`. Curves over time need no function, just an entry in
squat/replay/plots.py.
"""

from collections.abc import Callable, Sequence
from enum import Enum
from typing import NamedTuple

import rerun.blueprint as rrb

from squat.replay.recorder import Recorder
from squat.replay.runs import Run

Draw = Callable[[Recorder, tuple[Run, ...]], Sequence[rrb.View]]


class Place(Enum):
    """Where a panel stands."""

    PICTURE = "what moves, on top"
    PLOT = "curves over time, below"
    DIFFERENCE = "curves of what differs, below those"
    PROFILE = "distributions at the time shown, on the right"
    TEXT = "text, on the right"
    ENERGY = "where the energy is, in a tab of its own"


class Panel(NamedTuple):
    """A function that draws, where its views stand, and the variables it needs."""

    place: Place
    needs: tuple[str, ...]
    draw: Draw


AT_ONCE = 2
"""Pictures that stand one above the other; more are tabs."""
PANELS: dict[str, Panel] = {}


def panel(name: str, place: Place, needs: tuple[str, ...]) -> Callable[[Draw], Draw]:
    """Register a function as the panel `name`."""

    def register(draw: Draw) -> Draw:
        PANELS[name] = Panel(place, needs, draw)
        return draw

    return register


def picture_aspect(alone: float, count: int) -> float:
    """Width over height of each of `count` pictures, where a single one has that of `alone`."""
    return alone * count if count <= AT_ONCE else alone


def draw_all(recorder: Recorder, runs: tuple[Run, ...]) -> dict[Place, list[rrb.View]]:
    """Views of all panels that the runs have the variables for, by place."""
    views: dict[Place, list[rrb.View]] = {place: [] for place in Place}
    for place, needs, draw in PANELS.values():
        able = tuple(run for run in runs if run.has(*needs))
        if able:
            views[place].extend(draw(recorder, able))
    return views
