"""Hulls that differ in shape alone: equal in what they should be, ordered by what theory says."""

from dataclasses import replace

import numpy as np
import pytest
from matplotlib.backends.backend_agg import FigureCanvasAgg

from squat.channel import Polygon
from squat.errors import InputError
from squat.figures.hull_shapes import hull_shapes as draw
from squat.fluid.run import run as added_mass
from squat.stability import hull_shapes, limits
from squat.stability.equilibria import OneDimensionalModel
from squat.stability.local_depth import LocalDepthModel
from squat.water import Water
from tests.hulls import CHANNEL, NAMES, hull

QUICK = "accuracy.near=0.32", "accuracy.far=0.4"
WATER = Water(density=1000.0, gravity=9.81)


def mirrored(given: Polygon) -> Polygon:
    points = [(given.length - x, z) for x, z in given.points]
    return replace(given, points=tuple(points[::-1]))


@pytest.fixture(scope="module")
def few(case):
    """The box, the polygon both ways round, and the V."""
    asked = case("hull_shapes", *QUICK)
    hulls = {name: asked.hulls[name] for name in ("v", "polygon", "rectangle")}
    hulls["backwards"] = mirrored(asked.hulls["polygon"])
    return hull_shapes.run(replace(asked, hulls=hulls))


def test_all_ready_made_hulls_are_compared_at_one_draft_and_area(case):
    asked = case("hull_shapes", "draft=8.0", "displacement=300.0")
    assert set(asked.hulls) == set(NAMES)
    for name in asked.hulls:
        outline = hull_shapes.alike(asked, name).outline
        assert outline.area == pytest.approx(300, rel=1e-10)
        assert outline.draft == pytest.approx(8, rel=1e-10)


def test_the_box_is_the_ship_of_the_task_limits(case, few):
    box, data = few.sel(hull="rectangle"), limits.run(case("limits", *QUICK, "accuracy=study"))
    names = ("limit_1d", "limit_2d", "limit_dynamic")
    assert [float(box[name]) for name in names] == pytest.approx(data["limit_speed"], rel=1e-9)
    errors = [float(box[f"{name}_error"]) for name in names[1:]]
    assert errors == pytest.approx(data["limit_error"].values[1:], rel=1e-3)
    assert float(box["equilibrium"]) == pytest.approx(float(data["equilibrium"]), rel=1e-9)
    still = limits.run(case("limits", *QUICK, "accuracy=study", "current=0.0"))
    assert float(box["period"]) == pytest.approx(float(still["linear_period"]), rel=1e-9)
    assert float(box["block_coefficient"]) == pytest.approx(1, rel=1e-12)


def test_added_mass_is_that_of_heave_on_heave(case, few):
    """Eq. (23) by the task of its own; heave alone of several modes, positive for every hull."""
    box = few.sel(hull="rectangle")
    data = added_mass(case("added_mass", *QUICK, "mesh=coarse"))
    error = float(
        box["added_mass_ratio_error"] + data["added_mass_error"].max() / data["ship_mass"]
    )
    assert float(box["added_mass_ratio"]) == pytest.approx(float(data["mass_ratio"]), abs=error)
    assert bool((few["added_mass_ratio"] > 1).all())


def test_a_hull_goes_backwards_as_fast_as_forwards(few):
    """phi_0 backwards is phi_0 but for exp(-pi D/H) of In and Out; the period feels In's place."""
    ahead, astern = few.sel(hull="polygon"), few.sel(hull="backwards")
    decay = np.exp(-2 * np.pi * CHANNEL.upstream / CHANNEL.depth)
    for name in ("limit_2d", "limit_dynamic", "equilibrium"):
        error = float(ahead[f"{name}_error"]) + float(astern[f"{name}_error"])
        assert float(ahead[name]) == pytest.approx(float(astern[name]), rel=decay, abs=error)
    assert float(ahead["period"]) != pytest.approx(float(astern["period"]), rel=1e-2)


def test_what_lies_near_the_bottom_decides(few):
    """Finer hulls go faster and sink less; Eq. (27) takes all for boxes and cannot tell.

    Water that turns round the ends sucks more than 1D flow: the 2D limits are the lower.
    """
    data = few.sortby("block_coefficient")
    assert np.ptp(data["limit_1d"].values) < 1e-12
    for name in ("limit_local", "limit_2d", "limit_dynamic", "equilibrium"):
        v, astern, ahead, box = data.sel(hull=["v", "backwards", "polygon", "rectangle"])[name]
        assert v > max(astern, ahead)
        assert min(astern, ahead) > box
    assert (data["limit_2d"] < data["limit_local"]).all()


@pytest.mark.parametrize("name", ["rectangle", "polygon", "v", "half_ellipse"])
def test_the_local_limit_is_where_stiffness_and_suction_of_every_edge_balance_last(name):
    """int dx/h^2 over a straight edge is dx/(h_0 h_1); V^2 over w has its maximum at the fold."""
    model = LocalDepthModel(hull(name), CHANNEL, WATER)
    x, z = hull(name).outline.vertices.T
    w = np.linspace(-6, -1, 20001)[:, None]
    h = CHANNEL.depth + z + w
    suction = (np.diff(x) * (CHANNEL.depth**2 / (h[:, :-1] * h[:, 1:]) - 1)).sum(axis=1)
    square = -2 * WATER.gravity * hull(name).length * w[:, 0] / suction
    assert model.squat_speed().speed == pytest.approx(np.sqrt(square.max()), rel=1e-7)
    assert model.squat_speed().sinkage == pytest.approx(float(w[square.argmax(), 0]), abs=1e-3)


def test_the_local_limit_of_a_box_is_that_of_eq_27():
    box = hull("rectangle")
    one = OneDimensionalModel(box, CHANNEL, WATER).squat_speed()
    assert LocalDepthModel(box, CHANNEL, WATER).squat_speed().speed == pytest.approx(one.speed)


@pytest.mark.parametrize(
    ("keys", "said"),
    [
        (("displacement=5.0",), "hulls.chamfered_box: displacement=5: no length"),
        (("draft=0.5",), "hulls.chamfered_box: hull.chamfer=2: must be less"),
        (("start.heave=1.0",), "hulls.lewis: start.heave=1: must be between"),
        (("channel.depth=9.0",), "hulls.chamfered_box: hull.draft=10: must be less"),
    ],
)
def test_a_hull_that_cannot_be_is_named(case, keys, said):
    asked = case("hull_shapes", *QUICK, *keys)
    chosen = said.split(":")[0].removeprefix("hulls.")
    with pytest.raises(InputError, match=said):
        hull_shapes.run(replace(asked, hulls={chosen: asked.hulls[chosen]}))


def test_a_wrong_key_of_one_hull_of_many_is_named(case):
    with pytest.raises(InputError, match=r"hulls\.v\.wall=11: must be less than hull\.draft"):
        case("hull_shapes", "hulls.v.wall=11.0")


def test_the_picture_holds_every_hull_and_is_not_cut_off(few):
    figure = draw(few)
    FigureCanvasAgg(figure).draw()
    texts = [text for axes in figure.axes for text in (axes.title, axes.xaxis.label)]
    names = figure.axes[0].get_yticklabels()
    assert len(names) == 4
    assert names[0].get_text().startswith("rectangle")
    for text in (*texts, *names, *figure.legends[0].get_texts()):
        box = text.get_window_extent()
        assert figure.bbox.contains(box.x0, box.y0)
        assert figure.bbox.contains(box.x1, box.y1)
