"""The answer of task `limits` in words."""

import math
from collections.abc import Mapping
from typing import Any

from squat.stability.case import LimitsCase
from squat.stability.digits import measured
from squat.stability.formulas import KNOT

_SAME = 1e-6
"""Difference over a limit from which on the 1D model along the hull is another one than the box."""


def summary(case: LimitsCase, data: Mapping[str, Any]) -> str:
    """Lines for a reader: speed, limits, formulas, warnings."""
    return "\n".join([*_at_speed(case, data), *_limits(data), *_formulas(data), *_warnings(data)])


def _at_speed(case: LimitsCase, data: Mapping[str, Any]) -> list[str]:
    equilibrium = measured(float(data["equilibrium"]), float(data["equilibrium_error"]), "m")
    least = measured(float(data["least_clearance"]), float(data["least_clearance_error"]), "m")
    period = measured(float(data["period"]), float(data["period_error"]), "s")
    linear = measured(float(data["linear_period"]), 0.0, "s")
    return [
        f"at {case.current:g} m/s ({case.current / KNOT:.3g} kn, "
        f"Fr_h = {float(data['depth_froude_number']):.3f})",
        f"  equilibrium           w = {equilibrium}",
        f"  clearance there       {measured(float(data['under_keel_clearance']), 0.0, 'm')}",
        f"  least clearance       {least}, from w(0) = {case.start.heave:g} m, "
        f"w'(0) = {case.start.velocity:g} m/s",
        f"  period                {period} (small motion: {linear})",
    ]


def _limits(data: Mapping[str, Any]) -> list[str]:
    lines = ["limits in heave alone (task=trim gives those in heave and pitch)"]
    for name, speed, error, froude in zip(
        data["limit"],
        data["limit_speed"],
        data["limit_error"],
        data["limit_froude_number"],
        strict=True,
    ):
        text = measured(float(speed), float(error), "m/s")
        lines.append(f"  {name:<22}{text} (Fr_h = {float(froude):.3f})")
    box, local = float(data["limit_speed"][0]), float(data["limit_local"])
    if not math.isclose(box, local, rel_tol=_SAME):
        lines.insert(
            2, f"  {'1D along the hull':<22}{measured(local, 0.0, 'm/s')} (its own clearance)"
        )
    return lines


def _formulas(data: Mapping[str, Any]) -> list[str]:
    lines = ["usual formulas"]
    for name, squat, limit, note in zip(
        data["formula"],
        data["formula_squat"],
        data["formula_limit"],
        data["formula_note"],
        strict=True,
    ):
        said = [f"squat {squat:.4g} m"] if math.isfinite(squat) else []
        said += [f"limit {limit:.4g} m/s"] if math.isfinite(limit) else []
        said += [note] if note else []
        lines.append(f"  {name:<22}{'; '.join(said)}")
    return lines


def _warnings(data: Mapping[str, Any]) -> list[str]:
    return ["mind", *(f"  {text}" for text in data["warning"])]
