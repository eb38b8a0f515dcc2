"""The equilibria of one ship over speed, from the case to its dataset."""

from typing import Annotated

import numpy as np
import xarray as xr
from pydantic import Field
from pydantic.dataclasses import dataclass

from squat.channel import AnyHull, Channel
from squat.quantities import STRICT, Count, NonNegative, Speed
from squat.records import build
from squat.records.stability_kinds import EQUILIBRIA
from squat.stability.equilibria import OneDimensionalModel
from squat.water import Water


@dataclass(frozen=True, kw_only=True, config=STRICT)
class Speeds:
    """Speeds at which equilibria are wanted.

    Parameters
    ----------
    least, greatest
        Ends of the curve over speed [m/s] (Table 6).
    points
        Points of that curve.
    cases
        Single speeds [m/s] (Table 7).
    """

    least: Speed
    greatest: Speed
    points: Count
    cases: Annotated[tuple[Speed, ...], Field(min_length=1)]


@dataclass(frozen=True, kw_only=True, config=STRICT)
class EquilibriaCase:
    """A ship in a channel and the speeds to look at (section 3.3).

    Parameters
    ----------
    added_mass_ratio
        m_add/m of heave, for the linear period only.
    """

    hull: AnyHull
    channel: Channel
    water: Water
    speeds: Speeds
    added_mass_ratio: NonNegative


def run(case: EquilibriaCase) -> xr.Dataset:
    """Dataset of kind `equilibria`."""
    model = OneDimensionalModel(case.hull, case.channel, case.water)
    speed = np.linspace(case.speeds.least, case.speeds.greatest, case.speeds.points)
    roots, cases = model.roots(speed), model.roots(case.speeds.cases)
    mass = case.water.density * case.hull.outline.area
    fold = model.squat_speed()
    data = {
        "speed": speed,
        "stable": roots.stable,
        "unstable": roots.unstable,
        "unphysical": roots.unphysical,
        "stable_stiffness": model.stiffness(roots.stable, speed),
        "unstable_stiffness": model.stiffness(roots.unstable, speed),
        "period": model.period(roots.stable, speed, (1 + case.added_mass_ratio) * mass),
        "case_speed": list(case.speeds.cases),
        "case_stable": cases.stable,
        "case_unstable": cases.unstable,
        "squat_speed": fold.speed,
        "squat_sinkage": fold.sinkage,
    }
    return build(EQUILIBRIA, data, {"squat_speed_bracket": fold.width})
