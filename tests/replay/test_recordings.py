"""Recordings read back: entities, rows, times and values against the datasets they show."""

import subprocess
from pathlib import Path

import numpy as np
import pytest
import rerun
import rerun_cli

import squat as package
from squat import records
from squat.replay.channel import Extent
from squat.replay.chart import _HANGING
from squat.replay.overlay import difference
from squat.replay.panels import PANELS, Place, panel
from squat.replay.runs import labels, load
from squat.replay.wires import affine
from squat.stability.equilibria import OneDimensionalModel

NANOSECOND = 1e-9
SINGLE = 2e-7  # relative, of numbers kept in single precision


def scalars(entity):
    return np.array(entity.rows["scalars"])[:, 0]


def one_each(entity, name):
    return [np.array(row[0]) for row in entity.rows[name]]


@pytest.fixture(scope="module")
def shown(record, entities, ship):
    return entities(record(ship)), records.read(ship), records.read_group(ship, "fields")


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


def test_both_roots_are_level_lines_from_start_to_end(shown):
    found, data, _ = shown
    for name in ("stable_root", "unstable_root"):
        line = found[f"plots/heave/{name}"]
        assert list(scalars(line)) == [float(data[name])] * 2
        assert line.time == pytest.approx(data["time"].values[[0, -1]], abs=NANOSECOND)


def test_mesh_moves_with_the_snapshots_and_brighter_is_higher_pressure(shown):
    found, _, fields = shown
    mesh = found["channel/mesh"]
    assert mesh.time == pytest.approx(fields["time"].values, abs=NANOSECOND)
    assert np.array_equal(mesh.rows["triangle_indices"][0], fields["face_node"].values)
    places = np.array(mesh.rows["vertex_positions"])
    assert np.array_equal(places[..., 0], fields["x"].values)
    assert np.array_equal(places[..., 2], fields["z"].values)
    packed = np.array(mesh.rows["vertex_colors"], np.uint32)
    green = packed >> 16 & 255  # rises along the whole map
    dynamic = fields["pressure"].values - 9810 * (20 - fields["z"].values)
    order = np.argsort(dynamic, axis=None)
    assert np.all(np.diff(green.ravel()[order].astype(int)) >= 0)
    assert np.ptp(green) > 200


def test_arrows_are_velocities_of_their_nodes_to_one_scale(shown):
    found, _, fields = shown
    arrows = found["channel/velocity"]
    assert len(arrows.time) == fields.sizes["time"]
    for n, (origins, vectors) in enumerate(
        zip(arrows.rows["origins"], arrows.rows["vectors"], strict=True)
    ):
        origin, vector = np.array(origins), np.array(vectors)
        x, z = (fields[name].values[n] for name in "xz")
        nodes = [int(np.argmin((x - o[0]) ** 2 + (z - o[2]) ** 2)) for o in origin]
        speed = np.stack([fields[f"velocity_{a}"].values[n][nodes] for a in "xz"], axis=1)
        scale = np.linalg.norm(vector) / np.linalg.norm(speed)
        assert vector[:, [0, 2]] == pytest.approx(scale * speed, rel=10 * SINGLE, abs=1e-6)
        assert 50 < len(nodes) < 200
        assert len(set(nodes)) == len(nodes)


def test_wires_lie_on_the_moved_mesh(shown):
    found, _, fields = shown
    sides = 0
    for name, zone in found.items():
        if not name.startswith("channel/wires/"):
            continue
        lines = np.array(zone.rows["strips"][0])
        maps = np.array([row[0] for row in zone.rows["mat3x3"]]).reshape(-1, 3, 3)
        shifts = np.array([row[0] for row in zone.rows["translation"]])
        sides += len(lines)
        for n in (0, len(shifts) - 1):
            # rerun keeps matrices column after column.
            moved = np.einsum("cr,kic->kir", maps[n], lines) + shifts[n]
            nodes = np.stack([fields["x"].values[n], fields["z"].values[n]], axis=1)
            gaps = np.linalg.norm(moved.reshape(-1, 3)[:, None, [0, 2]] - nodes[None], axis=2)
            assert gaps.min(axis=1).max() < 1e-3
    faces, nodes = fields.sizes["face"], fields.sizes["node"]
    assert sides >= faces + nodes - 1  # Euler; sides between zones are drawn with both


def test_affine_maps_are_found_exactly():
    rng = np.random.default_rng(1)
    start, matrix, shift = rng.normal(size=(9, 2)), rng.normal(size=(2, 2)), rng.normal(size=2)
    maps, shifts = affine(np.stack([start, start @ matrix.T + shift]))
    assert maps == pytest.approx(np.stack([np.eye(2), matrix]), abs=1e-12)
    assert shifts == pytest.approx(np.stack([np.zeros(2), shift]), abs=1e-12)


def test_hull_moves_by_heave_and_water_and_bottom_stand(shown, ship):
    found, data, _ = shown
    (run,) = load((str(ship),))
    extent = Extent.of(run)
    strips = one_each(found["channel/hull"], "strips")
    heave = data["heave"].values[:: run.config["snapshots"]]
    size = len(extent.hull)
    assert extent.hull[[0, -1]].tolist() == [[0, 20], [40, 20]]
    assert extent.hull[1:-1].tolist() == [[0, 10], [40, 10]]
    for strip, w in zip(strips, heave, strict=True):
        assert strip[:size, 2] - w == pytest.approx(extent.hull[:, 1], abs=1e-5)
        assert np.array_equal(strip[0], strip[-1])
    water = np.array(found["channel/water_line"].rows["strips"][0])
    assert np.all(water[..., 2] == extent.depth)
    assert list(water[:, :, 0].ravel()) == [extent.inlet, 0.0, extent.hull[-1, 0], extent.outlet]
    assert found["channel/bottom"].time == []


def reader_of(found, name):
    """Numbers that a reader takes from a diagram by its labelled axes."""
    numbers = found[f"axes/{name}/numbers"].rows
    places, words = np.array(numbers["positions"][0]), numbers["labels"][0][:-2]
    values = np.array([float(word) for word in words])
    low = places[:-2, 1] == places[:-2, 1].max()
    across = np.polyfit(places[:-2][low, 0], values[low], 1)
    up = np.polyfit(places[:-2][~low, 1] + _HANGING, values[~low], 1)
    return lambda strip: (np.polyval(across, strip[:, 0]), np.polyval(up, strip[:, 1]))


def test_keel_pressure_reads_as_the_dataset_and_the_level_line_balances_eq_27(shown, case):
    found, data, _ = shown
    read = reader_of(found, "keel_pressure")
    two = one_each(found["profiles/keel_pressure/two_dimensional"], "strips")
    one = one_each(found["profiles/keel_pressure/one_dimensional"], "strips")
    assert len(one) == len(two) == data.sizes["time"]
    keel = data["hull_z"].values <= float(data["hull_z"].min()) + 1e-9
    ship = case("transient", "current=2.0")
    model = OneDimensionalModel(ship.hull, ship.channel, ship.water)
    for n, w in enumerate(data["heave"].values):
        x, pressure = read(two[n])
        static = 9810 * (10 - w)
        here = (data["hull_pressure"].values[n, keel] - static) / 1000
        frame = pressure.min() + 1e-6, pressure.max() - 1e-6
        inner = (frame[0] < pressure) & (pressure < frame[1])  # what leaves the frame is cut
        assert inner.sum() > 0.6 * len(x)
        assert x == pytest.approx(data["hull_x"].values[keel], abs=1e-4)
        assert pressure[inner] == pytest.approx(here[inner], abs=1e-4)
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
    for words in ("**Status: completed**", "| current V | 2 | m/s |", "| draft T | 10 | m |"):
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


def test_compared_runs_stand_on_one_axis_with_their_difference(record, entities, ship, bare):
    found = entities(record(ship, bare))
    first, other = records.read(ship), records.read(bare)
    for label, data in {"ship": first, "bare": other}.items():
        assert np.array_equal(scalars(found[f"{label}/plots/heave/heave"]), data["heave"].values)
    change = found["bare/differences/heave/heave"]
    common = first["time"].values <= other["time"].values[-1]
    assert change.time == pytest.approx(first["time"].values[common], abs=NANOSECOND)
    there = np.interp(first["time"].values[common], other["time"].values, other["heave"].values)
    assert np.array_equal(scalars(change), there - first["heave"].values[common])


def test_a_run_less_itself_is_nothing(ship, tmp_path):
    copy = tmp_path / "copy.nc"
    copy.write_bytes(ship.read_bytes())
    first, other = load((str(ship), str(copy)))
    clock, values = difference(first, other, lambda data: data["heave"])
    assert np.all(values == 0)
    assert len(clock.time) == first.data.sizes["time"]


def test_labels_say_what_differs_and_no_more():
    def named(*paths):
        return labels([Path(path) for path in paths])

    assert named("a/run.nc", "b/run.nc") == ["a", "b"]
    assert named("a.nc", "x/b.2.nc") == ["a", "b.2"]
    assert named("a/run.nc") == [""]
    assert named("x/v-1__s-5/run.nc", "x/s-5__v-2/run.nc") == ["v-1", "v-2"]
    assert named("a/x/1.nc", "a/y/2.nc", "b/x/2.nc") == ["x/1", "y/2", "x/2"]


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
