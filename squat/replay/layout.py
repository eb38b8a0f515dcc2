"""The first look of a recording: pictures over curves on the left, the step shown on the right.

Where the energy is stands in a second tab on the left.
"""

import rerun.blueprint as rrb

from squat.replay.panels import AT_ONCE, Place
from squat.replay.runs import Run

_PLAYED_IN = 20.0  # s on the watch for a whole run
_COLUMNS = (4.0, 1.6)
_IN_A_ROW = 3  # plots whose titles and legends can be read


def blueprint(views: dict[Place, list[rrb.View]], runs: tuple[Run, ...]) -> rrb.Blueprint:
    """Arrange `views` by place; play all runs on the axis of time."""
    last = max(float(run.span.time[-1]) for run in runs)
    return rrb.Blueprint(
        rrb.Horizontal(_left(views), _right(views), column_shares=_COLUMNS),
        rrb.TimePanel(
            timeline="sim_time",
            state="collapsed",
            playback_speed=max(last / _PLAYED_IN, 1e-3),
            play_state="playing",
            loop_mode="all",
        ),
        rrb.BlueprintPanel(state="collapsed"),
        rrb.SelectionPanel(state="collapsed"),
        auto_views=False,
        auto_layout=False,
    )


def _left(views: dict[Place, list[rrb.View]]) -> rrb.Container:
    pictures, plots = views[Place.PICTURE], views[Place.PLOT]
    differences = views[Place.DIFFERENCE]
    below: list[rrb.Container]
    if differences and len(plots) > _IN_A_ROW:
        below = [
            rrb.Tabs(
                rrb.Grid(*plots, grid_columns=_IN_A_ROW, name="Curves"),
                rrb.Grid(*differences, grid_columns=_IN_A_ROW, name="Differences"),
            )
        ]
        shares = [1.0, 1.4]
    elif differences:
        below = [rrb.Horizontal(*plots), rrb.Horizontal(*differences)]
        shares = [1.6, 1.0, 1.0]
    else:
        below = [rrb.Grid(*plots, grid_columns=2 if len(plots) == 4 else _IN_A_ROW)]
        shares = [1.0, 1.4]
    many = len(pictures) > AT_ONCE
    above = rrb.Tabs(*pictures) if many else rrb.Vertical(*pictures)
    motion = rrb.Vertical(above, *below, row_shares=shares, name="Motion")
    if not views[Place.ENERGY]:
        return motion
    return rrb.Tabs(motion, rrb.Grid(*views[Place.ENERGY], grid_columns=2, name="Energy"))


def _right(views: dict[Place, list[rrb.View]]) -> rrb.Container:
    profiles = views[Place.PROFILE]
    return rrb.Vertical(
        rrb.Tabs(*views[Place.TEXT]), *profiles, row_shares=[1.4, *[1.0] * len(profiles)]
    )
