"""All heats, over the cores, as one dataset."""

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np
import xarray as xr

from squat.cores import spread
from squat.coupling import NoAcceleration
from squat.dynamics import IntegratorName
from squat.dynamics.hydrostatics import heave_stiffness
from squat.fluid.curves import Curves
from squat.fluid.potential import PotentialFluid
from squat.fluid.rates import RATES, RateName
from squat.mesh import submesh
from squat.mesh.generate import generate
from squat.quantities import Vector
from squat.race.case import RaceCase
from squat.race.entrants import Column, Entrant
from squat.race.heats import SCHEMES, Heat
from squat.race.ship import LightShip
from squat.records import build
from squat.records.coupling_kinds import RACE

RULES: dict[IntegratorName, RateName] = {"newmark": "backward", "centred": "centred"}
"""Integrators and the ship's d phi/dt with them: `coupling=newmark` and `coupling=printed`."""
ENTRANTS = ("piston", "sprung", "ship")
_REACH = 0.5
"""Share of the clearance below, and of the draft above, that the ship's curves reach to."""

Entering = Callable[[str, float, IntegratorName], Entrant]


def entering(case: RaceCase) -> Entering:
    """Entrant by name, mass ratio and integrator; the ship's curves are made once."""
    mesh = generate(submesh(case.hull, case.channel, ("heave",)), case.mesh)
    fluid = PotentialFluid(mesh, case.water, "rigid_lid", case.current)
    limits = mesh.submesh.limits
    curves = Curves.of(fluid, -_REACH * limits.clearance, _REACH * limits.draft)
    inertia = float(curves.values(case.initial_heave)[2])
    blend = PotentialFluid(mesh, case.water, "blend", case.current)
    paper = float(blend.coefficients(np.zeros(1)).c[0, 0])
    length = case.hull.outline.length

    def enter(name: str, mass_ratio: float, integrator: IntegratorName) -> Entrant:
        if name != "ship":
            piston = replace(case.piston, mass_ratio=mass_ratio)
            return Column.of(piston, case.water, sprung=name == "sprung")
        return LightShip(
            curves,
            inertia / mass_ratio,
            heave_stiffness(case.water, length),
            case.water.density * length * case.current**2 / 2,
            case.current,
            RATES[RULES[integrator]],
            case.initial_heave,
            paper,
        )

    return enter


def run(case: RaceCase) -> xr.Dataset:
    """Dataset of kind `race`."""
    enter = entering(case)
    cells, names = case.cells, list(case.accelerators)
    shape = (len(ENTRANTS), len(RULES), len(cells.mass_ratios), len(cells.steps_per_period))
    heats = [
        Heat(case, enter(name, ratio, integrator), integrator, steps)
        for name in ENTRANTS
        for integrator in RULES
        for ratio in cells.mass_ratios
        for steps in cells.steps_per_period
    ]
    found = _all(heats, _race, "heats")
    spoilt = [
        Heat(case, enter(name, cells.factor_mass_ratio, "newmark"), "newmark", cells.factor_steps)
        for name in ENTRANTS
    ]
    swept = _all(spoilt, _spoil, "wrong added masses")
    ship = enter("ship", 1.0, "newmark")
    data: dict[str, Any] = {
        "problem": list(ENTRANTS),
        "integrator": list(RULES),
        "mass_ratio": list(cells.mass_ratios),
        "steps_per_period": list(cells.steps_per_period),
        "scheme": list(SCHEMES),
        "accelerator": names,
        "factor": list(cells.factors),
        "time_step": np.reshape([heat.dt for heat in heats], shape)[:, 0],
        "hull_density": float(ship.mass[0, 0])
        / np.array(cells.mass_ratios)
        / case.hull.outline.area,
    }
    for name in found[0]:
        data[name] = np.array([row[name] for row in found]).reshape(shape + found[0][name].shape)
    for name in swept[0]:
        data[name] = np.array([row[name] for row in swept])
    how = {
        "factor_mass_ratio": cells.factor_mass_ratio,
        "factor_steps": cells.factor_steps,
        "current": case.current,
        "tolerance": case.tolerance,
    }
    return build(RACE, data, how)


def _all(
    heats: list[Heat], task: Callable[[Heat], dict[str, Vector]], label: str
) -> list[dict[str, Vector]]:
    """`task` of every heat over the cores; those of many steps start first."""
    return spread(task, ((heat,) for heat in heats), label, cost=lambda heat: heat.steps)


def _race(heat: Heat) -> dict[str, Vector]:
    """Every scheme with every accelerator: arrays (scheme, accelerator) and (scheme,)."""
    reference = heat.reference()
    scale = abs(heat.entrant.displacement)
    results = [
        [heat.run(scheme, accelerator) for accelerator in heat.case.accelerators.values()]
        for scheme in SCHEMES
    ]
    plain = [heat.run(scheme, NoAcceleration(name="none")) for scheme in SCHEMES]
    return {
        "mean_iterations": np.array([[result.mean for result in row] for row in results]),
        "status": np.array([[result.status for result in row] for row in results]),
        "difference": np.array(
            [
                [
                    np.abs(result.history - reference.history).max() / scale
                    if result.status == "converged"
                    else np.nan
                    for result in row
                ]
                for row in results
            ]
        ),
        "contraction": np.array([result.contraction for result in plain]),
        "predicted_contraction": np.array(
            [heat.factor(heat.added_mass(scheme)) for scheme in SCHEMES]
        ),
    }


def _spoil(heat: Heat) -> dict[str, Vector]:
    """Constant m_add wrong by every factor: arrays (factor, accelerator) and (factor,)."""
    right = heat.added_mass("consistent")
    masses = [factor * right for factor in heat.case.cells.factors]
    return {
        "factor_iterations": np.array(
            [
                [heat.run_with(mass, one).mean for one in heat.case.accelerators.values()]
                for mass in masses
            ]
        ),
        "factor_predicted_contraction": np.array([heat.factor(mass) for mass in masses]),
    }
