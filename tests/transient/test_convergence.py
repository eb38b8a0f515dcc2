"""Headline numbers with their uncertainty: orders that theory predicts, errors that hold."""

import numpy as np
import pytest

from squat import records
from squat.errors import InputError
from squat.fluid.accuracy import extrapolate, observed_order
from squat.report.estimates import estimates
from squat.transient import convergence


@pytest.fixture(scope="module")
def study(case):
    return convergence.run(case("convergence", "cases/convergence@_global_=small"))


def rows(study, word):
    return study.isel(quantity=[word in str(name) for name in study["quantity"].values])


def test_mesh_numbers_converge_faster_than_linear_elements_could(study):
    """Energies of linear elements have order two at most, quadratic ones on fine meshes four."""
    on_meshes = study.isel(quantity=study["refined"].values == "mesh")
    assert (on_meshes["observed_order"] > 2).all()
    assert (on_meshes["error"] < 1e-2 * np.abs(on_meshes["value"])).all()


def test_time_steps_show_the_orders_of_their_schemes(study):
    """Both readings tend to one motion: the first-order one within its own, larger error."""
    printed, consistent = rows(study, "printed: time"), rows(study, "consistent: time")
    apart = abs(float(printed["value"].item() - consistent["value"].item()))
    assert apart < float(printed["error"].item() + consistent["error"].item())
    assert consistent["observed_order"].item() == pytest.approx(2, abs=0.25)
    assert printed["error"].item() > 10 * consistent["error"].item()


@pytest.mark.parametrize("order", [1, 4 / 3, 2, 4])
def test_observed_order_is_that_of_a_single_power(order):
    levels = [np.array([1.0 + 3.0 * h**order]) for h in (0.4, 0.2, 0.1)]
    assert observed_order(levels, 2.0) == pytest.approx([order])
    value, error = extrapolate(levels, 2.0, 1.25)
    assert value == pytest.approx([1.0])
    assert error == pytest.approx(1.25 * 3.0 * 0.1**order, rel=1e-6)


@pytest.mark.parametrize("levels", [(1.0, 2.0, 1.5), (1.0, 2.0, 3.0), (1.0, 1.0, 1.0)])
def test_changes_that_do_not_shrink_have_no_order_and_their_size_as_error(levels):
    values = [np.array([value]) for value in levels]
    assert np.isnan(observed_order(values, 2.0)).all()
    value, error = extrapolate(values, 2.0, 1.25)
    assert value == [levels[-1]]
    assert error == pytest.approx([1.25 * abs(levels[-1] - levels[-2])], abs=1e-9)


def test_report_names_each_number_with_its_error(study, tmp_path):
    records.save(study, tmp_path / "convergence.nc", {"task": "convergence"}, 0.0)
    shown = estimates(tmp_path / "convergence.nc")
    assert len(shown) == study.sizes["quantity"]
    assert all("+-" in row.estimate for row in shown)
    assert sum(row.refined == "time step" for row in shown) == 4


@pytest.mark.parametrize("key", ["time.until=end", "modes=[heave,pitch]", "currents=[]"])
def test_impossible_studies_are_refused_by_name(case, key):
    with pytest.raises(InputError, match=key.split("=")[0].replace(".", r"\.")):
        case("convergence", key)
