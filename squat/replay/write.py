"""Write the recording of one run or of several."""

import re
from pathlib import Path

import rerun as rr

import squat
from squat import records
from squat.replay import (  # noqa: F401  (register panels)
    case_text,
    channel,
    overlay,
    portrait,
    profiles,
    tube,
)
from squat.replay.case import ReplayCase
from squat.replay.ends import clear_ended
from squat.replay.layout import blueprint
from squat.replay.panels import draw_all
from squat.replay.recorder import Recorder
from squat.replay.runs import Run, load


def write_replay(case: ReplayCase, path: Path) -> None:
    """Write the recording to `path` (.rrd), whole or not at all.

    Raises
    ------
    InputError
        Naming a dataset that is absent, broken, foreign or of another kind than the first, or
        `path` where it cannot be written.
    """
    runs = load(case.files)
    rr.set_strict_mode(True)  # without it rerun warns of data that it drops
    with records.atomic(path) as temporary:
        stream = rr.RecordingStream(
            _application(runs), recording_id=_identity(runs), send_properties=False
        )
        stream.save(temporary)
        stream.send_recording_name(" and ".join(run.label or run.path.stem for run in runs))
        stream.send_property("provenance", stamp(runs))
        recorder = Recorder(stream)
        views = draw_all(recorder, runs)
        clear_ended(recorder, runs)
        stream.send_blueprint(blueprint(views, runs))
        stream.flush()
        stream.disconnect()


def stamp(runs: tuple[Run, ...]) -> rr.AnyValues:
    """Versions and datasets that the recording is made of."""
    return rr.AnyValues(
        squat_version=squat.__version__,
        rerun_version=rr.__version__,
        dataset=[str(run.path) for run in runs],
        dataset_sha256=[str(run.data.attrs["content_sha256"]) for run in runs],
        status=[str(run.data.attrs["status"]) for run in runs],
    )


def _application(runs: tuple[Run, ...]) -> str:
    """Recordings of one application share a layout in the viewer: one for each set of entities."""
    name = " ".join(["squat", runs[0].kind, *(run.label for run in runs if run.label)])
    return re.sub(r"[^\w -]", "-", name)  # of others rerun makes its own, and warns


def _identity(runs: tuple[Run, ...]) -> str:
    """Equal for equal data, whoever records it."""
    return "-".join(str(run.data.attrs["content_sha256"])[:16] for run in runs)
