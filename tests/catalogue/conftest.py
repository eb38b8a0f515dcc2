"""Three runs of the piston that the tests of this room search and compare."""

import pytest

import squat as api
from tests.catalogue.runs import RATIOS


@pytest.fixture(scope="module")
def runs(tmp_path_factory):
    folder = tmp_path_factory.mktemp("runs")
    for ratio in RATIOS:
        run = api.run("piston", "scheme=standard", "time.periods=0.5", f"piston.mass_ratio={ratio}")
        (folder / f"deep/{ratio}").mkdir(parents=True)
        run.to_netcdf(folder / f"deep/{ratio}/piston.nc", engine="h5netcdf")
    api.run("equilibria").to_netcdf(folder / "roots.nc", engine="h5netcdf")
    return folder
