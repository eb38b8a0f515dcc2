"""Mesh, arrows, wires and hull of a recording against the snapshots that they show."""

import numpy as np
import pytest
import rerun as rr

from squat.replay.channel import Extent, channel
from squat.replay.overlay import time_axis
from squat.replay.panels import picture_aspect
from squat.replay.recorder import Recorder
from squat.replay.runs import load
from squat.replay.wires import affine
from tests.replay.reading import NANOSECOND, SINGLE, one_each


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


SHALLOW = (
    "mesh.near=3", "mesh.far=6", "accuracy=coarse", "force=variational", "model=curves",
    "coupling=energy_momentum", "current=0.5", "time.periods=0.05", "hull.length=140",
    "hull.draft=8", "channel.depth=11", "channel.upstream=140", "channel.downstream=210",
)  # fmt: skip


def test_a_long_shallow_channel_is_drawn_higher_than_it_is_and_the_view_says_so(
    record, entities, written, shown
):
    path = written("shallow", "transient", *SHALLOW)
    (run,) = load((str(path),))
    times = Extent.of(run).stretch
    assert 4 < 490 / (times * 11) < 12
    found = entities(record(path))
    assert found["channel"].rows["scale"] == [[[1, 1, times]]]
    levels = np.array(found["channel/water_line"].rows["strips"][0])[..., 2]
    assert np.all(levels == 11)  # data stay metres, the picture stretches them
    (view,) = channel(Recorder(rr.RecordingStream("test")), (run,))
    assert str(view.name).endswith(f"heights × {times}")
    assert "channel" not in shown[0]  # of the paper's ship: equal scales


def test_the_colour_bar_has_one_share_of_the_picture_however_short_the_channel(
    entities, record, written
):
    """Its numbers are as large in all pictures: over a bar that shrinks they would overlap."""
    keys = "current=1.0", "mesh=coarse", "time.periods=0.02", "snapshots=2"
    short = "hull.length=20.0", "channel.upstream=10.0", "channel.downstream=10.0"
    found = entities(record(written("brief", "transient", *keys, *short)))
    (bar,) = [rows for path, rows in found.items() if "color_bar" in path and "numbers" not in path]
    places = np.array(bar.rows["vertex_positions"])[..., 0]
    high = (1 + 0.75 + 0.3) * 20.0  # depth and the margins above and below
    assert np.ptp(places) == pytest.approx(0.6 * high * picture_aspect(3.0, 1), rel=1e-6)
    assert np.ptp(places) > 40.0  # the channel itself


@pytest.mark.parametrize("last", [2, 129])
def test_diagrams_show_all_of_a_run(last):
    """Linked axes would differ by what their curves have, and show 30 s around the one played."""
    (whole,) = time_axis(float(last)).view_range.as_arrow_array().to_pylist()
    assert [whole[end] for end in ("start", "end")] == [0, last * 10**9]
