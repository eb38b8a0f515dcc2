"""The equilibria of one ship over speed, from the case to its dataset."""

import math

import xarray as xr
from pydantic.dataclasses import dataclass

from squat.channel import AnyHull, Channel
from squat.fluid.accuracy import Accuracy, accurate
from squat.quantities import STRICT, NonNegative
from squat.records import build
from squat.records.stability_kinds import EQUILIBRIA
from squat.stability.digits import measured
from squat.stability.equilibria import Fold, OneDimensionalModel
from squat.stability.speeds import Speeds
from squat.water import Water

_HEAVE = 1


@dataclass(frozen=True, kw_only=True, config=STRICT)
class EquilibriaCase:
    """A ship in a channel and the speeds to look at (section 3.3).

    Parameters
    ----------
    accuracy
        Meshes that m_add is computed on where it is not given.
    added_mass_ratio
        m_add/m of heave, for the linear period only; None: that of Eq. (23) for this hull.
    """

    hull: AnyHull
    channel: Channel
    water: Water
    accuracy: Accuracy
    speeds: Speeds
    added_mass_ratio: NonNegative | None


def run(case: EquilibriaCase) -> xr.Dataset:
    """Dataset of kind `equilibria`, with the answer in words as its attribute `summary`."""
    model = OneDimensionalModel(case.hull, case.channel, case.water)
    fold = model.squat_speed()
    speed, single = case.speeds.curve(fold.speed), case.speeds.single(fold.speed)
    roots, cases = model.roots(speed), model.roots(single)
    ratio, error = _added_mass_ratio(case)
    inertia = (1 + ratio) * case.water.density * case.hull.outline.area
    data = {
        "speed": speed,
        "stable": roots.stable,
        "unstable": roots.unstable,
        "unphysical": roots.unphysical,
        "stable_stiffness": model.stiffness(roots.stable, speed),
        "unstable_stiffness": model.stiffness(roots.unstable, speed),
        "period": model.period(roots.stable, speed, inertia),
        "added_mass_ratio": ratio,
        "added_mass_ratio_error": error,
        "case_speed": single,
        "case_stable": cases.stable,
        "case_unstable": cases.unstable,
        "squat_speed": fold.speed,
        "squat_sinkage": fold.sinkage,
    }
    period = float(model.period(0.0, 0.0, inertia))
    summary = _summary(case, fold, measured(ratio, error), period)
    return build(EQUILIBRIA, data, {"squat_speed_bracket": fold.width, "summary": summary})


def _added_mass_ratio(case: EquilibriaCase) -> tuple[float, float]:
    """m_add/m of heave with its error; NaN where the number is the user's."""
    if case.added_mass_ratio is not None:
        return case.added_mass_ratio, math.nan
    area = case.hull.outline.area
    value, error = accurate(case.hull, case.channel, case.accuracy, "zero_pressure")
    return float(value[_HEAVE, _HEAVE]) / area, float(error[_HEAVE, _HEAVE]) / area


def _summary(case: EquilibriaCase, fold: Fold, ratio: str, period: float) -> str:
    froude = fold.speed / math.sqrt(case.water.gravity * case.channel.depth)
    bed = " over a flat bottom" if case.channel.bottom else ""
    source = "as given" if case.added_mass_ratio is not None else "zero pressure, Eq. (23)"
    return (
        f"small heave in still water has a period of {period:.4g} s with m_add/m = {ratio} "
        f"({source}); under a rigid lid it is longer (task=limits)\n"
        f"squat speed {fold.speed:.6g} m/s (Fr_h = {froude:.3f}) at w = {fold.sinkage:.4g} m by "
        f"Eq. (27), which takes any hull for a box of its draft{bed}; task=limits takes it as it is"
    )
