"""The bound holds, is sharp enough to be useful, and the model is as good as promised."""

import numpy as np
import pytest

from squat.mesh import PositionError
from squat.reduced import bounds
from squat.reduced.terms import ShortForm

OVERESTIMATE = 100
"""Promised: the median of bound over error."""


def entries(coefficients, slopes):
    return np.concatenate([np.ravel(part) for part in (*coefficients, *slopes)])


def errors_and_bounds(pair, positions):
    full = pair.full()
    rows = []
    for q in positions:
        exact = entries(full.coefficients(q), full.slopes(q))
        found = entries(pair.model.coefficients(q), pair.model.slopes(q))
        bound = bounds(pair.model, q)
        rows.append((np.abs(found - exact), entries(bound.coefficients, bound.slopes), exact))
    return map(np.array, zip(*rows, strict=True))


def report(capsys, label, errors, certified):
    seen = errors > 0
    ratio = certified[seen] / errors[seen]
    with capsys.disabled():
        print(
            f"\n{label}: bound over error, median {np.median(ratio):.0f}, least {ratio.min():.2g}"
        )
    return float(np.median(ratio))


@pytest.mark.parametrize("positions", [6, 11, 20])
def test_error_never_exceeds_the_bound_in_heave(pair, capsys, positions):
    two = pair("mesh=coarse", f"reduced.positions={positions}")
    errors, certified, _ = errors_and_bounds(two, two.positions())
    assert np.all(errors <= certified)
    assert report(capsys, f"heave, {positions} positions", errors, certified) < OVERESTIMATE


def test_error_never_exceeds_the_bound_in_heave_and_pitch(pitch, capsys):
    errors, certified, _ = errors_and_bounds(pitch, pitch.positions())
    assert np.all(errors <= certified)
    assert report(capsys, "heave and pitch, 16 positions", errors, certified) < OVERESTIMATE


def test_bound_holds_where_current_and_motion_have_two_free_surfaces(pair):
    two = pair("mesh=coarse", "free_surface=blend", "reduced.positions=8")
    errors, certified, _ = errors_and_bounds(two, two.positions(50))
    assert np.all(errors <= certified)
    assert np.all(two.model.coefficients(two.positions(1)[0]).b == 0)


@pytest.mark.parametrize(
    "keys", [("hull=lewis",), ("hull=v",), ("channel.bottom=[[10,0],[20,2]]", "hull=half_ellipse")]
)
def test_bound_holds_for_any_hull_over_any_bottom(pair, keys):
    two = pair("mesh=coarse", "mesh.near=2", "mesh.far=5", "reduced.positions=6", *keys)
    errors, certified, _ = errors_and_bounds(two, two.positions(40))
    assert np.all(errors <= certified)


def test_heave_model_has_energies_and_forces_to_1e8_from_20_solves(heave):
    assert len(heave.made.rounds) <= 20
    errors, _, exact = errors_and_bounds(heave, heave.positions())
    assert np.max(errors / np.abs(exact)) < 1e-8


def test_fields_are_those_of_the_full_mesh_to_1e6(heave):
    full, fluid = heave.full(), heave.loaded.fluid(heave.case.water, 0.0)
    for q in heave.positions(50):
        for mine, exact in zip(fluid.unit_potentials(q), full.unit_potentials(q), strict=True):
            assert np.abs(mine - exact).max() < 1e-6 * np.abs(exact).max()


def test_certificate_of_the_fields_covers_the_energy_of_their_error(heave):
    """|e|_K^2 = E_ii: with few functions, where the error is far above rounding."""
    affine = heave.full()._affine
    for q in heave.positions(20):
        K = affine.at(q)
        exact = heave.full().unit_potentials(q)[1][0]
        error = heave.loaded.fluid(heave.case.water, 0.0).unit_potentials(q)[1][0] - exact
        norm = np.sqrt((error @ (K @ error)) / (exact @ (K @ exact)))
        assert norm <= bounds(heave.model, q).fields[1] + 1e-9


def test_slopes_are_the_derivatives_of_the_reduced_energies(heave, pitch):
    """Galerkin on a fixed basis is consistent: the model has an energy of its own."""
    for model, q in ((heave.model, np.array([-4.0])), (pitch.model, np.array([-4.0, 0.01]))):
        for k, h in enumerate([1e-4, 1e-6][: len(q)]):
            step = h * np.eye(len(q))[k]
            ahead, behind = model.energies(q + step), model.energies(q - step)
            slopes, rate = model.slopes(q), (ahead - behind) / (2 * h)
            assert slopes.a[k] == pytest.approx(rate[0, 0], rel=1e-6, abs=1e-6 * ahead[0, 0])
            assert slopes.b[:, k] == pytest.approx(rate[0, 1:], rel=1e-6, abs=1e-6 * ahead[0, 1])
            assert slopes.c[..., k] == pytest.approx(rate[1:, 1:], rel=1e-6, abs=1e-5 * ahead[1, 1])


def test_coercivity_bounds_the_least_eigenvalue(heave, at):
    from scipy.sparse.linalg import eigsh

    affine = heave.full()._affine
    free = heave.full()._lid.free
    X = affine.at(heave.model.box.middle)[free][:, free]
    for w in (-9.8, -5.0, 4.0):
        K = affine.at(at(w))[free][:, free]
        least = eigsh(K, k=1, M=X, sigma=0, return_eigenvectors=False)[0]
        alpha, _ = heave.model.metric_range(at(w))
        assert 0.3 * least < alpha <= least * (1 + 1e-9)


def test_few_terms_span_all_coefficients_at_any_position(heave, pitch):
    for two, count in ((heave, 7), (pitch, 23)):
        affine = two.full()._affine
        samples = np.array([affine.theta(q) for q in two.model.box.grid()])
        short = ShortForm.of(samples.T)
        assert len(short.chosen) == count
        scale = np.maximum(np.abs(samples).max(axis=0), np.finfo(float).tiny)
        for q in two.positions(50, seed=3):
            theta = affine.theta(q)
            apart = np.abs(short.weights @ theta[short.chosen] - theta)
            assert np.all(apart <= 1e-11 * scale)


def test_greedy_choice_halves_the_bound_faster_than_it_adds_positions(heave):
    worst = np.array([found.worst for found in heave.made.rounds])
    assert worst[-1] < 1e-5 * worst[0]


def test_positions_out_of_the_box_are_refused_by_name(heave, pitch, at):
    with pytest.raises(PositionError, match="grounded"):
        heave.model.coefficients(at(-9.95))
    with pytest.raises(PositionError, match="draft/2"):
        heave.model.coefficients(at(5.5))
    with pytest.raises(PositionError, match=r"raise reduced\.box\.pitch"):
        pitch.model.coefficients(at(-1, 0.03))
