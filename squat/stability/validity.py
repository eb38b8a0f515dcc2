"""What to mind before using the limits of a ship: the model's assumptions, with their size here."""

import math
from collections.abc import Mapping
from typing import Any

from squat.stability.case import LimitsCase

_VISCOSITY = 1e-6
"""Kinematic viscosity of water [m2/s], for the estimate of the boundary layer alone."""
_LAYER = 0.1
"""Share of the gap that a boundary layer may fill unmentioned."""
_NEAR = 0.9
"""Share of the dynamic limit above which a speed counts as near to it."""


def warnings(case: LimitsCase, data: Mapping[str, Any]) -> list[str]:
    """One sentence for each assumption that matters here."""
    one, _, dynamic = (float(speed) for speed in data["limit_speed"])
    return [*_speed(case, data, dynamic), *_model(case, one), *_geometry(case), *_gap(case, data)]


def _speed(case: LimitsCase, data: Mapping[str, Any], dynamic: float) -> list[str]:
    speed, start = case.current, case.start
    free = f"set free at w(0) = {start.heave:g} m with w'(0) = {start.velocity:g} m/s"
    if speed >= dynamic:
        kept = math.isfinite(data["equilibrium"])
        still = " though there is an equilibrium" if kept else ": there is no equilibrium"
        return [f"at {speed:g} m/s the ship {free} is lost{still}"]
    if speed > _NEAR * dynamic:
        return [f"{speed:g} m/s is {100 * (1 - speed / dynamic):.1f} % below the dynamic limit"]
    return []


def _model(case: LimitsCase, fastest: float) -> list[str]:
    head = case.water.gravity * case.channel.depth
    found = [
        "two dimensions: the ship fills the channel's width, no water passes beside it; "
        "in a wider channel it squats less",
        "heave alone: free to trim, the ship passes a lower barrier; the 2D and dynamic limits "
        "are upper bounds in that respect",
    ]
    if case.free_surface == "rigid_lid":
        found.append(
            "rigid lid: the lowering of the surface and waves are neglected, an effect of the "
            f"order of Fr_h^2, {100 * fastest**2 / head:.1f} % at the 1D limit; periods depend on "
            "channel.upstream, through which all displaced water leaves"
        )
    else:
        found.append(
            "blend: the hull's motion feels zero pressure on the surface, the current a lid"
        )
    return found


def _geometry(case: LimitsCase) -> list[str]:
    found = []
    if case.hull.shape != "rectangle":
        found.append("1D limit: takes the hull for a box of its length and draft")
    if chords := getattr(case.hull, "segments", None):
        found.append(
            f"chords: the hull's bends are chords (hull.segments={chords}), errors told are those "
            "of the elements on them; twice as many show what the chords leave out"
        )
    if case.channel.bottom:
        found.append("1D limit and formulas: take the bottom for flat at channel.depth")
    return found


def _gap(case: LimitsCase, data: Mapping[str, Any]) -> list[str]:
    """Turbulent boundary layer, 0.37 L Re^(-1/5), against the gap at equilibrium or at rest."""
    gap, where = float(data["under_keel_clearance"]), ""
    if math.isnan(gap):
        gap, where = case.channel.depth - case.hull.outline.draft, " at rest"
    if not gap > 0 or case.current == 0:
        return []
    length, speed = case.hull.outline.length, case.current * case.channel.depth / gap
    layer = 0.37 * length * (speed * length / _VISCOSITY) ** -0.2
    if layer < _LAYER * gap:
        return []
    share = f"{min(100 * layer / gap, 100.0):.0f} % of the gap{where}"
    return [f"no viscosity: a boundary layer of {layer:.2g} m would fill {share}"]
