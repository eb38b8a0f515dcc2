"""Pictures of the domain, its mesh and its flow."""

from itertools import combinations

import numpy as np
import pytest
from matplotlib.backends.backend_agg import FigureCanvasAgg

from squat.figures.added_mass import fig7
from squat.figures.domain import fig3, fig8
from squat.figures.isolines import numbers
from squat.figures.mesh import fig6
from squat.fluid.run import run as added_mass
from squat.mesh.run import run as mesh

DEEP = "channel.bottom=[[-10,0],[10,4],[30,4],[60,-15]]"


@pytest.mark.parametrize("hull", ["rectangle", "lewis"])
def test_labels_of_isovalues_stay_apart_and_off_the_hull(case, hull):
    data = added_mass(case("added_mass", f"hull={hull}", "mesh=coarse"))
    faces = data["face_node"].values
    sides = np.sort(faces[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2), axis=1)
    unique, count = np.unique(sides, axis=0, return_counts=True)
    rim = np.unique(unique[count == 1])
    rim = np.column_stack([data["node_x"][rim], data["node_z"][rim]])
    for axes in fig7(data).axes:
        places = [np.array(text.get_position()) for text in axes.texts]
        assert len(places) > 4
        assert all(np.linalg.norm(rim - place, axis=1).min() > 1 for place in places)
        assert all(np.linalg.norm(a - b) > 1 for a, b in combinations(places, 2))


BARGE = ("hull.length=110.0", "hull.draft=3.2", "channel.depth=4.5", "channel.upstream=110.0")


def test_isovalues_under_a_long_hull_have_their_numbers(case):
    data = added_mass(case("added_mass", "mesh=coarse", "accuracy.near=0.4", *BARGE))
    for axes in fig7(data).axes:
        assert sum(0 < text.get_position()[0] < 110 for text in axes.texts) > 4
        assert axes.xaxis.get_tick_params()["labelbottom"]


SLAB = ("hull.length=190.0", "hull.draft=10.5", "channel.depth=13.0", "channel.upstream=190.0")


def outline(text):
    """The turned rectangle of the white behind a drawn number."""
    patch = text.get_bbox_patch()
    return patch.get_transform().transform_path(patch.get_path())


@pytest.mark.parametrize("more", [("hull=fig7", "channel=fig7"), SLAB])
def test_numbers_of_isolines_are_whole_and_read_from_one_side(case, more):
    figure = fig7(added_mass(case("added_mass", "mesh=coarse", *more)))
    FigureCanvasAgg(figure).draw()
    for axes in figure.axes:
        boxes = [text.get_window_extent() for text in axes.texts if "×" not in text.get_text()]
        assert len(boxes) > 8
        assert all(axes.bbox.y0 < box.y0 and box.y1 < axes.bbox.y1 for box in boxes)
        rim = [axes.transData.transform(line.get_xydata()) for line in axes.lines]
        rim = np.vstack([np.linspace(*edge, 20) for edge in rim])
        for box in boxes:
            inside = (rim > (box.x0, box.y0)) & (rim < (box.x1, box.y1))
            assert not inside.all(axis=1).any()
        frames = [outline(text) for text in axes.texts if "×" not in text.get_text()]
        assert not any(a.intersects_path(b) for a, b in combinations(frames, 2))
        for text in axes.texts:
            assert (text.get_rotation() + 70) % 360 < 180
            assert text.get_text().strip() not in {"6", "9", "\N{MINUS SIGN}6", "\N{MINUS SIGN}9"}


@pytest.mark.parametrize(
    ("values", "texts"),
    [
        ((6, 7, -8), ["6.0", "7.0", "\N{MINUS SIGN}8.0"]),
        ((9,), ["9.0"]),
        ((68,), ["68.0"]),
        ((600, 60, 12), ["600", "60", "12"]),
        ((0.8, 1.6, 4), ["0.8", "1.6", "4.0"]),
        ((), []),
    ],
)
def test_numbers_are_told_apart_upside_down_and_have_as_many_decimals(values, texts):
    assert numbers(values) == texts


@pytest.mark.parametrize("more", [("hull=curve",), BARGE])
def test_no_label_of_a_dimension_crosses_hull_or_bottom(case, more):
    figure = fig8(mesh(case("mesh", "mesh=coarse", *more)))
    FigureCanvasAgg(figure).draw()
    (axes,) = figure.axes
    labels = [text for text in axes.texts if "=" in text.get_text()]
    assert len(labels) == 6
    for text in labels:
        box = text.get_window_extent().padded(-1)
        for line in axes.lines[:-1]:
            points = axes.transData.transform(line.get_xydata())
            steps = np.linspace(points[:-1], points[1:], 50).reshape(-1, 2)
            assert not any(box.contains(x, y) for x, y in steps)


@pytest.mark.parametrize("draw", [fig3, fig6, fig8])
def test_heights_of_long_shallow_channels_are_stretched_and_a_note_says_so(case, draw):
    wide = draw(mesh(case("mesh", "mesh=coarse", *BARGE))).axes[0]
    assert wide.get_aspect() == round((110 + 110 + 60) / 4.5 / 8)
    assert f"heights × {wide.get_aspect():g}" in [text.get_text() for text in wide.texts]
    plain = draw(mesh(case("mesh", "mesh=coarse"))).axes[0]
    assert plain.get_aspect() == 1
    assert not any("heights" in text.get_text() for text in plain.texts)


@pytest.mark.parametrize("draw", [fig3, fig8])
def test_nothing_is_cut_off_over_a_deep_bottom(case, draw):
    figure = draw(mesh(case("mesh", "mesh=coarse", DEEP, "position.heave=0.0")))
    FigureCanvasAgg(figure).draw()
    (axes,) = figure.axes
    for text in (axes.title, axes.xaxis.label, axes.yaxis.label):
        box = text.get_window_extent()
        assert figure.bbox.contains(box.x0, box.y0)
        assert figure.bbox.contains(box.x1, box.y1)
