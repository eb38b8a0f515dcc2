"""Task `inertia`: every cell where its keys say, extrapolated and on one linear mesh."""

import numpy as np
import pytest

from squat.fluid.inertia import run
from squat.fluid.matching import RectangleReference, rigid_modes

HEAVE = {"heave": rigid_modes(0.0, 0.0)["heave"]}


def test_cells_are_those_of_the_independent_method(case):
    cells = (
        "cells.depth_over_draft=[2]",
        "cells.a_over_T=[0.5,2]",
        "cells.readings=[depth]",
    )
    inertia = case("inertia", "accuracy=study", *cells)
    data = run(inertia)
    distance, depth = inertia.cells.distance, inertia.cells.depth
    assert list(data["a_over_T"].values) == [0.5, 2]
    for i in range(data.sizes["cell"]):
        one = data.isel(cell=i)
        draft = depth / float(one["depth_over_draft"])
        length = 2 * float(one["a_over_T"]) * draft
        exact = RectangleReference(length, draft, depth, distance, distance, "zero_pressure")
        value = exact.added_mass(HEAVE)[0, 0] / (np.pi * (length / 2) ** 2)
        assert float(one["inertia_coefficient"]) == pytest.approx(value, rel=1e-4)
        # Linear elements on the paper's mesh: the corner's h^(4/3), from below.
        assert 0.97 * value < float(one["inertia_coefficient_mesh"]) < value
        assert float(one["mesh_nodes"]) > 1000
