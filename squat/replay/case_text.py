"""What was run, in words: status, parameters with units, provenance."""

import math
from collections.abc import Callable
from typing import NamedTuple

import rerun as rr
import rerun.blueprint as rrb

import squat
from squat.replay.panels import Place, panel
from squat.replay.recorder import Recorder, entity
from squat.replay.runs import Run


class Row(NamedTuple):
    """A parameter: name, value, unit. The unit stands behind the value: a third column is cut."""

    name: str
    value: object
    unit: str = ""


_READING = """
Time axes: `sim_time`, and `phase` = omega t, on which one second stands for one radian.
"""


@panel("case", Place.TEXT, ())
def case(recorder: Recorder, runs: tuple[Run, ...]) -> list[rrb.View]:
    """One page a run."""
    views: list[rrb.View] = []
    for run in runs:
        path = entity(run, "case")
        columns = rr.TextDocument.columns(text=[page(run)], media_type=["text/markdown"])
        recorder.static(path, columns)
        views.append(rrb.TextDocumentView(origin=f"/{path}", name=run.said("case")))
    return views


def page(run: Run) -> str:
    """Markdown page of a run."""
    rows = "\n".join(f"| {row.name} | {_value(row)} |" for row in ROWS[run.kind](run))
    attributes = run.data.attrs
    return (
        f"# {run.data.attrs['title']}\n\n"
        f"**Status: {attributes['status']}** after {run.data.sizes['time'] - 1} steps, "
        f"at {run.steps.time[-1]:.4g} s.\n"
        f"\n| parameter | value |\n|---|---|\n{rows}\n"
        f"{_READING}\n"
        f"Dataset `{run.path.name}`, SHA-256 of its values `{attributes['content_sha256']}`, "
        f"written by {attributes['source']}. Recording by squat {squat.__version__} with rerun "
        f"{rr.__version__}: open it with this minor version of rerun or one next to it, or make it "
        "again from the dataset.\n"
    )


def _value(row: Row) -> str:
    """The value with its unit; that of a root which is not there is none."""
    if not isinstance(row.value, float):
        return f"{row.value} {row.unit}".rstrip()
    return "none" if math.isnan(row.value) else f"{row.value:.6g} {row.unit}".rstrip()


def _ship(run: Run) -> list[Row]:
    config, data = run.config, run.data
    hull, channel, coupling = config["hull"], config["channel"], config["coupling"]
    shape = run.chosen("hull", hull["shape"])
    scheme = run.chosen("coupling", coupling["name"])
    return [
        Row("current V", float(config["current"]), "m/s"),
        Row(f"length L ({shape})", float(hull["length"]), "m"),
        Row("draft T", float(hull["draft"]), "m"),
        Row("depth H", float(channel["depth"]), "m"),
        Row("In to bow", float(channel["upstream"]), "m"),
        Row("stern to Out", float(channel["downstream"]), "m"),
        Row("initial heave w(0)", float(config["initial_heave"]), "m"),
        Row("stable root of (27), a box", float(data["stable_root"]), "m"),
        Row("unstable root of (27), a box", float(data["unstable_root"]), "m"),
        Row("ship mass m", float(data["ship_mass"]), "kg/m"),
        Row("added mass m_add, Eq. (23)", float(data["added_mass"]), "kg/m"),
        Row("free surface", config["free_surface"]),
        Row("force of the water", data.attrs["force"]),
        Row("flow model", data.attrs["model"]),
        Row("coupling", f"{scheme} ({coupling['scheme']})"),
        Row("integrator", coupling["integrator"]),
        *_loop(run, coupling),
    ]


def _piston(run: Run) -> list[Row]:
    config, tube = run.config, run.config["piston"]
    return [
        Row("mean length L of the water", float(tube["length"]), "m"),
        Row("cross-section S", float(tube["area"]), "m2"),
        Row("water over piston mass m_f/m", float(tube["mass_ratio"])),
        Row("correction m_add/m_f", float(tube["added_mass_ratio"])),
        Row("initial position w(0)", float(tube["initial_position"]), "m"),
        Row("initial velocity w'(0)", float(tube["initial_velocity"]), "m/s"),
        Row("scheme", config["scheme"]),
        Row("integrator", config["integrator"]),
        Row("predicted contraction G", float(run.data["predicted_contraction"])),
        *_loop(run, config),
    ]


def _loop(run: Run, slots: dict[str, dict[str, object]]) -> list[Row]:
    """Slots of the coupling loop and the time scale."""
    water = run.config["water"]
    criterion = slots["criterion"]
    unit = "m" if criterion["name"] == "absolute" else ""
    return [
        Row("accelerator", slots["accelerator"]["name"]),
        Row("predictor", slots["predictor"]),
        Row(f"tolerance ({criterion['name']})", criterion["tolerance"], unit),
        Row("time step", float(run.data["time_step"]), "s"),
        Row("omega", run.omega, "rad/s"),
        Row("density of the water", float(water["density"]), "kg/m3"),
        Row("gravity", float(water["gravity"]), "m/s2"),
    ]


ROWS: dict[str, Callable[[Run], list[Row]]] = {"transient": _ship, "piston": _piston}
"""Parameters by kind of dataset."""
