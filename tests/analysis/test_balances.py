"""Gaps and yardsticks of the energy verdicts, by hand."""

import xarray as xr

from squat.analysis.balances import initial, kinetic, own_gap, whole_gap

RUN = xr.Dataset(
    {
        "ship_mass": ((), 3.0),
        "fluid_inertia": ("time", [1.0, 2.0, 7.0]),
        "heave_velocity": ("time", [0.0, -2.0, 1.0]),
        "kinetic_energy": ("time", [4.0, 6.0, 5.0]),
        "potential_energy": ("time", [-1.0, -2.0, -3.0]),
        "fluid_work": ("time", [0.0, -3.0, 2.0]),
        "energy_residual": ("time", [0.0, 0.25, -0.5]),
    }
)


def test_gaps_are_the_largest_distance_from_the_start():
    assert own_gap(RUN) == 2.0
    assert whole_gap(RUN) == 0.5


def test_yardsticks_are_the_energy_of_the_start_and_the_largest_of_ship_and_water():
    assert initial(RUN) == 3.0
    assert kinetic(RUN) == 10.0
