"""The answers of tasks `stability`, `hull_shapes` and `uneven_bottom` in words."""

from collections.abc import Mapping
from typing import Any

import numpy as np

from squat.stability.digits import measured


def stability(data: Mapping[str, Any]) -> str:
    """The limits on the one mesh, and the small motions at each of the single speeds."""
    start = f"from w(0) = {data['start_heave']:g} m, w'(0) = {data['start_velocity']:g} m/s"
    lines = [
        "limits in heave alone, on this one mesh (task=limits extrapolates, with errors)",
        f"1D           {_number(data['squat_speed_1d'], 'm/s')}",
        f"2D           {_number(data['squat_speed_2d'], 'm/s')}",
        f"dynamic      {_number(data['dynamic_squat_speed'], 'm/s')}, {start}",
    ]
    for V, stable, unstable in zip(
        data["case_speed"], data["case_stable"], data["case_unstable"], strict=True
    ):
        pair = f"stable {_number(stable, 'm')}, unstable {_number(unstable, 'm')}"
        lines.append(f"{f'at {V:g} m/s':<13}{pair}")
    return "\n  ".join(lines)


def hull_shapes(data: Mapping[str, Any]) -> str:
    """One line a hull: fullness, limits and sinkage, the fastest last."""
    names = [str(name) for name in data["hull"]]
    width = max(map(len, names))
    title = f"{'hull':<{width + 2}}  C_B   2D limit [m/s]       dynamic [m/s]        "
    lines = [f"{title}w at {data['current']:g} m/s [m]"]
    for i in np.argsort(data["limit_dynamic"]):
        cells = (
            measured(float(data[name][i]), float(data[f"{name}_error"][i]))
            for name in ("limit_2d", "limit_dynamic", "equilibrium")
        )
        text = "".join(f"{cell:<21}" for cell in cells).rstrip()
        lines.append(f"{names[i]:<{width}}  {data['block_coefficient'][i]:.2f}  {text}")
    return "\n  ".join(lines)


def uneven_bottom(data: Mapping[str, Any]) -> str:
    """Extremes of force and moment over the ramps, and the squat speed over each shelf."""
    at = f"held at {data['current']:g} m/s over a ramp of {data['shelf_rise']:g} m"
    lines = [f"{at}: force and moment less those of still water"]
    for name, unit in (("force", "N/m"), ("moment", "N")):
        least, greatest = (f"{end(data[name]):.4g}" for end in (np.min, np.max))
        lines.append(f"{name:<13}{least} to {greatest} {unit}")
    for rise, speed, error in zip(
        data["rise"], data["squat_speed"], data["squat_speed_error"], strict=True
    ):
        text = measured(float(speed), float(error), "m/s")
        lines.append(f"shelf of {rise:g} m: 2D squat speed {text}")
    return "\n  ".join(lines)


def _number(value: Any, unit: str) -> str:
    return measured(float(value), 0.0, unit)
