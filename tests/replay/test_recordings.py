"""Recordings read back: entities, rows, times and values against the datasets they show."""

import subprocess
from pathlib import Path

import numpy as np
import pytest
import rerun
import rerun_cli

import squat as package
from squat import records
from squat.replay.panels import PANELS, Place, panel
from squat.replay.recorder import Recorder
from squat.replay.runs import Clock
from squat.stability.equilibria import OneDimensionalModel
from tests.replay.reading import NANOSECOND, one_each, reader_of, scalars


def test_curves_have_the_values_and_both_times_of_the_dataset(shown):
    found, data, _ = shown
    curves = {
        "heave/heave": data["heave"],
        "contraction/measured": data["contraction"][1:],
        "contraction/expected": data["predicted_contraction"],
        "iterations/iterations": data["iterations"][1:],
        "ship_energies/kinetic": data["kinetic_energy"] / 1e6,
        "ship_energies/work": data["fluid_work"] / 1e6,
    }
    for name, values in curves.items():
        entity = found[f"plots/{name}"]
        assert np.array_equal(scalars(entity), values.values), name
        assert entity.time == pytest.approx(values["time"].values, abs=NANOSECOND)
        assert entity.phase == pytest.approx(values["phase"].values, abs=NANOSECOND)


def test_both_roots_are_level_lines_from_start_to_end(record, entities, kept):
    found, data = entities(record(kept)), records.read(kept)
    for name in ("stable_root", "unstable_root"):
        line = found[f"plots/heave/{name}"]
        assert list(scalars(line)) == [float(data[name])] * 2
        assert line.time == pytest.approx(data["time"].values[[0, -1]], abs=NANOSECOND)


def test_keel_pressure_reads_as_the_dataset_and_the_level_line_balances_eq_27(shown, case):
    found, data, _ = shown
    read = reader_of(found, "keel_pressure")
    two = found["profiles/keel_pressure/two_dimensional"].rows["strips"]
    one = one_each(found["profiles/keel_pressure/one_dimensional"], "strips")
    assert len(one) == len(two) == data.sizes["time"]
    keel = data["hull_z"].values <= float(data["hull_z"].min()) + 1e-9
    ship = case("transient", "current=2.0")
    model = OneDimensionalModel(ship.hull, ship.channel, ship.water)
    for n, w in enumerate(data["heave"].values):
        x, pressure = np.concatenate([read(np.array(piece)) for piece in two[n]], axis=1)
        static = 9810 * (10 - w)
        here = (data["hull_pressure"].values[n, keel] - static) / 1000
        assert len(x) > 0.6 * keel.sum()  # what leaves the frame is cut off
        along = np.interp(x, data["hull_x"].values[keel], here)
        assert pressure == pytest.approx(along, abs=1e-4 * np.ptp(here))
        _, level = read(one[n])
        length = ship.hull.length
        weight = 1000 * 9.81 * length * w  # what buoyancy alone leaves of the force
        assert level[0] * 1000 * length == pytest.approx(
            float(model.force(w, 2.0)) + weight, rel=1e-4
        )


def test_residuals_of_each_step_read_as_the_dataset(shown):
    found, data, _ = shown
    read = reader_of(found, "residuals")
    strips = one_each(found["profiles/residuals/step"], "strips")
    for strip, row in zip(strips, data["residual"].values[1:], strict=True):
        number, logarithm = read(strip)
        told = row[np.isfinite(row)]
        assert number == pytest.approx(np.arange(1, len(told) + 1), abs=1e-4)
        assert logarithm == pytest.approx(np.log10(told), abs=1e-4)


def test_without_snapshots_the_hull_still_moves_at_every_step(record, entities, bare):
    found, data = entities(record(bare)), records.read(bare)
    assert "channel/mesh" not in found
    assert len(found["channel/hull"].time) == data.sizes["time"]
    assert {"channel/water_line", "channel/bottom", "profiles/keel_pressure/two_dimensional"} <= (
        set(found)
    )


def test_case_and_stamp_tell_what_was_run_with_what(shown):
    found, data, _ = shown
    (text,) = found["case"].rows["text"][0]
    for words in ("**Status: completed**", "| current V | 2 m/s |", "| draft T | 10 m |"):
        assert words in text
    assert data.attrs["content_sha256"] in text
    assert package.__version__ in text
    assert rerun.__version__ in text


def test_stamp_is_a_property_of_the_recording(record, ship):
    recording = rerun.chunk.RrdReader(record(ship))
    rows = {}
    for chunk in recording.stream():
        if chunk.entity_path == "/__properties/provenance":
            batch = chunk.to_record_batch()
            rows = {name: batch.column(name).to_pylist()[0] for name in batch.schema.names}
    assert rows["squat_version"] == [package.__version__]
    assert rows["rerun_version"] == [rerun.__version__]
    assert rows["dataset_sha256"] == [records.read(ship).attrs["content_sha256"]]


def test_piston_replays_with_its_exact_solution(record, entities, tube):
    found, data = entities(record(tube)), records.read(tube)
    error = data["position"] - data["exact_position"]
    for name, values in {
        "position/position": data["position"],
        "position/exact_position": data["exact_position"],
        "error/error": error,
        "iterations/iterations": data["iterations"][1:],
    }.items():
        assert np.array_equal(scalars(found[f"plots/{name}"]), values.values), name
    water = np.array(found["tube/water"].rows["vertex_positions"])
    piston = np.array(found["tube/piston"].rows["vertex_positions"])
    assert len(water) == len(piston) == data.sizes["time"]
    level = water[:, 3, 2] - water[:, 0, 2]  # z_B - z_A = 2 w + constant, magnified
    magnified = np.polyfit(2 * data["position"].values, level, 1)
    assert np.polyval(magnified, 2 * data["position"].values) == pytest.approx(level, abs=1e-6)
    assert piston[:, 0, 2] == pytest.approx(water[:, 3, 2], abs=1e-6)
    period = data["time"].values[1] / data["time"].values[-1]
    assert found["plots/error/error"].phase[-1] == pytest.approx(np.pi, abs=1e-6)
    assert period > 0


def test_a_run_that_fails_at_once_keeps_two_times_and_no_empty_rows(record, entities, written):
    path = written("lost", "piston", "scheme=standard", "piston.mass_ratio=2")
    found, data = entities(record(path)), records.read(path)
    failed = found["profiles/residuals/failed_step"]
    assert failed.time == pytest.approx([float(data["time_step"])], abs=NANOSECOND)
    _, logarithm = reader_of(found, "residuals")(one_each(failed, "strips")[0])
    told = data["failed_residual"].values
    assert logarithm == pytest.approx(np.log10(told[told > 0]), abs=1e-3)
    assert "plots/iterations/iterations" not in found  # rerun's viewer fails on a chunk of none


@pytest.mark.parametrize(
    ("values", "how"),
    [
        ([1.0, 2.0, 3.0], {"widths"}),
        ([np.nan, 2.0, 3.0], {"widths"}),
        ([1.0, np.nan, 3.0], {"marker_sizes"}),
        ([np.nan, 2.0, np.nan], {"marker_sizes"}),
    ],
)
def test_no_line_is_drawn_through_steps_that_have_no_number(entities, tmp_path, values, how):
    stream = rerun.RecordingStream("gaps")
    stream.save(tmp_path / "gaps.rrd")
    moments = np.arange(3.0)
    Recorder(stream).series("line", Clock(moments, moments), np.array(values), "a", "#ffffff")
    stream.flush()
    stream.disconnect()
    line = entities(tmp_path / "gaps.rrd")["line"]
    assert how == line.rows.keys() & {"widths", "marker_sizes"}
    assert scalars(line) == pytest.approx([value for value in values if np.isfinite(value)])


def test_a_new_panel_is_a_function_and_a_list_of_variables(record, entities, ship, monkeypatch):
    monkeypatch.setattr("squat.replay.panels.PANELS", dict(PANELS))
    seen = []

    @panel("probe", Place.PROFILE, ("fluid_inertia",))
    def probe(recorder, runs):
        seen.extend(runs)
        return []

    @panel("nothing", Place.PROFILE, ("no_such_variable",))
    def nothing(recorder, runs):
        raise AssertionError

    record(ship)
    assert [run.path for run in seen] == [ship]


def test_rerun_verifies_every_recording(record, ship, bare, tube):
    tool = Path(rerun_cli.__file__).parent / "rerun"
    for path in (record(ship), record(ship, bare), record(tube)):
        done = subprocess.run(
            [tool, "rrd", "verify", path], capture_output=True, text=True, check=False
        )
        assert done.returncode == 0, done.stderr
        assert "0 errors" in done.stderr + done.stdout or "verified" in done.stderr + done.stdout


def test_size_follows_what_is_shown(record, ship, bare):
    fields = records.read_group(ship, "fields")
    shown = 16 * fields.sizes["time"] * fields.sizes["node"]  # positions and colours
    assert record(ship).stat().st_size - record(bare).stat().st_size < 2 * shown + 500_000
