"""What leaves the frame of a diagram is cut there, never drawn at its edge."""

import dataclasses

import numpy as np
import pytest
import rerun as rr

from squat import records
from squat.replay.chart import Chart
from squat.replay.cut import pieces
from squat.replay.field import bar_numbers
from squat.replay.profiles import (
    _ends,
    dynamic_pressure,
    keel,
    keel_pressure_panel,
    uniform_pressure,
)
from squat.replay.recorder import Recorder
from squat.replay.runs import Clock, load
from tests.replay.reading import one_each, reader_of

LOW, HIGH = np.zeros(2), np.ones(2)
CUT = "; cut at the frame"


@pytest.fixture
def drawn(tmp_path, entities):
    """What a function of a recorder has drawn."""

    def read(draw):
        stream = rr.RecordingStream("test")
        stream.save(tmp_path / "drawn.rrd")
        draw(Recorder(stream))
        stream.flush()
        stream.disconnect()
        return entities(tmp_path / "drawn.rrd")

    return read


@pytest.mark.parametrize(
    ("line", "kept"),
    [
        ([(0, 0), (1, 1)], [[(0, 0), (1, 1)]]),
        ([(-1, 0.5), (2, 0.5)], [[(0, 0.5), (1, 0.5)]]),
        ([(0, 0.5), (0.5, 3), (1, 0.5)], [[(0, 0.5), (0.1, 1)], [(0.9, 1), (1, 0.5)]]),
        ([(0, 3), (1, 3)], []),
        ([(-1, 1), (0.5, 1), (0.5, 0)], [[(0, 1), (0.5, 1), (0.5, 0)]]),
        ([(-1, 0.5), (0.5, 2)], []),
        ([(3, 3)], []),
    ],
)
def test_lines_end_where_they_leave_the_frame(line, kept):
    found = pieces(np.array(line, float), LOW, HIGH)
    assert [piece.shape for piece in found] == [np.shape(piece) for piece in kept]
    for piece, expected in zip(found, kept, strict=True):
        assert piece == pytest.approx(np.array(expected, float), abs=1e-12)


def test_a_chart_says_that_it_is_cut_only_where_it_is(drawn, tube):
    (run,) = load((str(tube),))
    clock = Clock(np.arange(2.0), np.arange(2.0))
    inside, outside = np.array([[0.2, 0.2], [0.4, 0.8]]), np.array([[0.0, 2.0], [1.0, 2.0]])
    for other, said in ((inside, ""), (outside, CUT)):
        chart = Chart("some", "Some", (0.0, 1.0), (0.0, 1.0), "x", "y")

        def draw(recorder, chart=chart, other=other):
            chart.curve(recorder, run, "line", clock, [inside, other], "red")
            chart.point(recorder, run, "point", clock, np.array([inside[0], other[0]]), "red")
            chart.view(recorder, (run,))

        found = drawn(draw)
        assert found["axes/some/numbers"].rows["labels"][0][-1] == f"y{said}"
        rows = 1 if said else 2
        assert sum(map(bool, found["profiles/some/line"].rows["strips"])) == rows
        assert sum(map(bool, found["profiles/some/point"].rows["positions"])) == rows
        assert len(found["profiles/some/line"].time) == 2


def test_the_frame_of_keel_pressure_holds_all_values_of_the_level_line(drawn, ship):
    """Even where the field's, here none, are far from them."""
    (run,) = load((str(ship),))
    pressure = run.data["hull_pressure"].copy()
    pressure.values[:, keel(run)] -= 1000 * dynamic_pressure(run)
    still = dataclasses.replace(run, data=run.data.assign(hull_pressure=pressure))
    assert np.abs(dynamic_pressure(still)).max() < 1e-9
    found = drawn(lambda recorder: keel_pressure_panel(recorder, (still,)))
    read = reader_of(found, "keel_pressure")
    lines = one_each(found["profiles/keel_pressure/one_dimensional"], "strips")
    for line, level in zip(lines, uniform_pressure(run), strict=True):
        assert read(line)[1] == pytest.approx([level] * 2, rel=1e-4)


@pytest.mark.parametrize(("least", "held"), [(-0.7, (-0.7, 1.0)), (-3.0, (0.05, 0.95))])
def test_the_frame_of_keel_pressure_leaves_out_what_would_flatten_the_bulk(least, held):
    field = np.linspace(0.0, 1.0, 101)
    field[0] = least
    assert _ends(field) == pytest.approx(held)


def test_residuals_of_a_run_that_fails_at_once_are_whole_beside_another(
    record, entities, written, tube
):
    lost = written("lost", "piston", "scheme=standard", "piston.mass_ratio=2")
    found, data = entities(record(lost, tube)), records.read(lost)
    assert not found["axes/residuals/numbers"].rows["labels"][0][-1].endswith(CUT)
    told = np.log10(data["failed_residual"].values)
    ((strip,),) = found["lost/profiles/residuals/failed_step"].rows["strips"]
    number, logarithm = reader_of(found, "residuals")(np.array(strip))
    assert number == pytest.approx(np.arange(1, len(told) + 1), abs=1e-4)
    assert logarithm == pytest.approx(told, abs=1e-4)


def test_ends_of_the_colour_bar_are_marked_where_pressures_are_beyond(shown):
    found, _, fields = shown
    words = found["channel/color_bar/numbers"].rows["labels"][0]
    dynamic = (fields["pressure"].values - 9810 * (20 - fields["z"].values)) / 1000
    low, high = np.nanquantile(dynamic, (0.05, 0.98))
    assert words[-2:] == [f"≤ {low:.3g} kPa", f"≥ {high:.3g} kPa"]
    assert len(words) > 3


def test_ends_of_the_colour_bar_that_hold_all_pressures_are_not_marked():
    assert bar_numbers((-1.0, 1.0), (-0.5, 0.5)) == {
        n: f"{n:g} kPa" for n in (-1.0, -0.5, 0.0, 0.5, 1.0)
    }
    assert bar_numbers((-1.0, 1.0), (-2.0, 0.5))[-1.0] == "≤ -1 kPa"
