"""The mesh-free references against each other and against closed forms."""

import numpy as np
import pytest

from squat.fluid.deep_water import heave_inertia_coefficient
from squat.fluid.matching import RectangleReference, rigid_modes

CASE = {"length": 40.0, "draft": 10.0, "depth": 20.0, "upstream": 40.0, "downstream": 60.0}
MODES = rigid_modes(20.0, 20.0)


@pytest.mark.parametrize("free_surface", ["zero_pressure", "rigid_lid"])
def test_matrix_is_reciprocal_and_positive_definite(free_surface):
    matrix = RectangleReference(**CASE, free_surface=free_surface).added_mass(MODES)
    scale = np.sqrt(np.outer(np.diag(matrix), np.diag(matrix)))
    assert np.abs((matrix - matrix.T) / scale).max() < 1e-8
    assert np.linalg.eigvalsh(matrix / scale).min() > 0


@pytest.mark.parametrize("free_surface", ["zero_pressure", "rigid_lid"])
def test_terms_and_functions_hardly_matter(free_surface):
    """Heave to nine digits; surge and pitch meet a second singularity, at the water line."""
    fine = RectangleReference(**CASE, free_surface=free_surface).added_mass(MODES)
    coarse = RectangleReference(**CASE, free_surface=free_surface, terms=40_000, functions=12)
    change = np.abs(coarse.added_mass(MODES) / fine - 1)
    assert change[1, 1] < 2e-9
    assert np.diag(change).max() < 3e-6


def test_square_in_deep_water_has_the_textbook_value():
    """4.754 rho a^2 for a full square of side 2a; the hull has half."""
    assert 2 * np.pi * heave_inertia_coefficient(1.0) == pytest.approx(4.754, abs=5e-4)


def test_flat_plate_limit_is_half_of_the_plates_circle():
    assert heave_inertia_coefficient(1e4) == pytest.approx(0.5, abs=1e-3)


@pytest.mark.parametrize("a_over_T", [0.5, 1.0, 2.0, 5.0])
def test_matching_tends_to_conformal_mapping_in_deep_water(a_over_T):
    """The bottom's images act like 1/H^2, then 1/H^4."""
    found = []
    for depth in (10.0, 20.0):
        sides = 20 * depth, 20 * depth
        case = RectangleReference(2 * a_over_T, 1.0, depth, *sides, "zero_pressure", 20_000, 32)
        found.append(case.added_mass({"heave": MODES["heave"]})[0, 0] / (np.pi * a_over_T**2))
    limit = found[1] + (found[1] - found[0]) / 3
    assert limit == pytest.approx(
        heave_inertia_coefficient(a_over_T), abs=((a_over_T + 1) / 20) ** 4
    )


def test_thin_gap_has_the_lubrication_slope():
    """di/d(a/T) -> 2/(3 pi (H/T - 1)): uniform horizontal flow in the gap."""
    ratio = 1.05
    i = [
        RectangleReference(2 * a, 1.0, ratio, 50.0, 50.0, "zero_pressure").added_mass(
            {"heave": MODES["heave"]}
        )[0, 0]
        / (np.pi * a**2)
        for a in (10.0, 12.0)
    ]
    assert (i[1] - i[0]) / 2 == pytest.approx(2 / (3 * np.pi * (ratio - 1)), rel=0.01)


def test_current_energy_is_that_of_the_channel_where_the_hull_is_a_thin_skim():
    flat = RectangleReference(40.0, 1e-6, 20.0, 40.0, 60.0, "rigid_lid")
    a, b = flat.current(MODES)
    assert a == pytest.approx(20.0 * 140.0, rel=1e-5)
    assert b[1] == pytest.approx(20.0 * 40.0 * 3, rel=1e-2)


def test_long_gap_has_the_one_dimensional_flow():
    """a/rho = H (D_up + D_down) + L H^2/d + end corrections that do not grow with L."""
    energies = [
        RectangleReference(length, 10.0, 20.0, 40.0, 60.0, "rigid_lid").current({})[0]
        for length in (100.0, 140.0)
    ]
    assert (energies[1] - energies[0]) / 40 == pytest.approx(20.0**2 / 10.0, rel=1e-9)


def test_deep_water_tends_to_the_flat_plate_from_above():
    """The thinner the box, the smaller its coefficient; 1/2 is that of a plate."""
    found = [heave_inertia_coefficient(ratio) for ratio in (0.05, 0.5, 1.0, 5.0, 100.0, 1000.0)]
    assert (np.diff(found) < 0).all()
    assert 0.5 < found[-1] < 0.505
