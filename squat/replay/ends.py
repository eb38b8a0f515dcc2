"""A run that has ended stands nowhere while others of its recording go on."""

from squat.replay.recorder import Recorder, entity
from squat.replay.runs import Clock, Run

_STEP = 0.01  # of a step: the row of the end itself is seen
_HELD = 0.03  # of the whole recording that a step which failed is seen


def clear_ended(recorder: Recorder, runs: tuple[Run, ...]) -> None:
    """Clear what moves of each run after its end, on the axes on which another goes on.

    At once, or after a moment for the eye where a step failed.
    """
    time, phase = (max(ends) for ends in zip(*(_ends(run.span) for run in runs), strict=True))
    for run in runs:
        held = _STEP * float(run.data["time_step"]) if run.failure is None else _HELD * time
        after = run.clock(run.span.time[-1:] + held)
        for axis, moment, last in zip(
            ("sim_time", "phase"), _ends(after), (time, phase), strict=True
        ):
            if moment < last:
                recorder.clear(entity(run), axis, moment)


def _ends(clock: Clock) -> tuple[float, float]:
    return float(clock.time[-1]), float(clock.phase[-1])
