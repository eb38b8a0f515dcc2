"""Iterations against mass ratio, added mass and density (Tables 2 and 3)."""

from dataclasses import replace
from typing import Annotated, Any

import numpy as np
import xarray as xr
from pydantic import Field
from pydantic.dataclasses import dataclass

from squat.cores import spread
from squat.coupling import SchemeName
from squat.coupling.amplification import predicted_iterations
from squat.dynamics import INTEGRATORS, IntegratorName
from squat.errors import InputError
from squat.piston.case import PistonCase
from squat.piston.run import run, steps
from squat.quantities import STRICT, Count, NonNegative, Positive, Vector
from squat.records import build
from squat.records.piston_kinds import ITERATIONS

Ratios = Annotated[tuple[Positive, ...], Field(min_length=1)]


@dataclass(frozen=True, kw_only=True, config=STRICT)
class PistonStudy:
    """The cells of the study.

    Parameters
    ----------
    mass_ratios
        m_f/m of Tables 2 and 3.
    added_mass_ratios
        m_add/m_f; 0 stands for the standard scheme.
    densities
        rho [kg/m3] of the sweep at constant piston mass m (that of `piston.mass_ratio` at
        `water.density`).
    density_added_mass_ratios
        m_add/m_f in that sweep.
    curve_points
        Mass ratios on each predicted curve.
    """

    mass_ratios: Ratios
    added_mass_ratios: Annotated[tuple[NonNegative, ...], Field(min_length=1)]
    densities: Ratios
    density_added_mass_ratios: Annotated[tuple[NonNegative, ...], Field(min_length=1)]
    curve_points: Count


@dataclass(frozen=True, kw_only=True, config=STRICT)
class StudyCase(PistonCase):
    """A piston run and the cells in which its ratios are varied."""

    cells: PistonStudy

    def __post_init__(self) -> None:
        if self.integrator == "energy_momentum":
            raise InputError(
                "integrator=energy_momentum: has no iterations between piston and water to count; "
                f"give one of {', '.join(INTEGRATORS)}"
            )


def with_ratios(case: PistonCase, mass_ratio: float, added_mass_ratio: float) -> PistonCase:
    """`case` with other masses; an added mass of 0 is the standard scheme."""
    piston = replace(case.piston, mass_ratio=mass_ratio, added_mass_ratio=added_mass_ratio)
    scheme: SchemeName = "corrected" if added_mass_ratio > 0 else "standard"
    return replace(case, piston=piston, scheme=scheme)


def with_density(case: PistonCase, density: float, added_mass_ratio: float) -> PistonCase:
    """`case` in another liquid, the piston's mass unchanged."""
    ratio = case.piston.mass_ratio * density / case.water.density
    water = replace(case.water, density=density)
    return with_ratios(replace(case, water=water), ratio, added_mass_ratio)


def measure(case: PistonCase) -> tuple[float, float, int, str]:
    """Mean iterations (infinite unless all steps converge), contraction, steps, status."""
    taken = steps(case)
    status = taken[-1].status
    converged = status == "converged"
    mean = float(np.mean([step.iterations for step in taken])) if converged else np.inf
    return mean, taken[0].contraction, len(taken) - (not converged), status


def predict(case: PistonCase) -> float:
    """Mean iterations that G and the exact motion (5) imply, from the `hold` predictor.

    Step n's first iterate repeats w''^n, so its error is dt^2/s3 |w''^n - w''^{n+1}|.
    """
    problem, dt = case.oscillator, case.dt
    start = problem.start(case.piston.initial_position, case.piston.initial_velocity)
    acceleration = -(problem.omega**2) * problem.exact(dt * np.arange(case.time.steps + 1), start)
    assert case.integrator != "energy_momentum"  # StudyCase refuses it
    error = dt**2 / INTEGRATORS[case.integrator].s3 * np.abs(np.diff(acceleration))
    return float(predicted_iterations(case.amplification(), error, case.criterion.tolerance).mean())


def observed_order(case: PistonCase, integrator: IntegratorName) -> float:
    """Order in dt of the error towards Eq. (5): greatest error with N and with 2 N steps.

    Run with m_add = m_f, where the iteration error is far below the discretisation's.
    """
    case = replace(with_ratios(case, case.piston.mass_ratio, 1.0), integrator=integrator)
    finer = replace(case.time, steps_per_period=2 * case.time.steps_per_period)
    errors = [
        float(abs(data["position"] - data["exact_position"]).max())
        for data in map(run, (case, replace(case, time=finer)))
    ]
    return float(np.log2(errors[0] / errors[1]))


def study(case: StudyCase) -> xr.Dataset:
    """Dataset of kind `iterations`: all cells, run over the cores."""
    cells = case.cells
    grid = [
        [with_ratios(case, m_f, m_add) for m_f in cells.mass_ratios]
        for m_add in cells.added_mass_ratios
    ]
    sweep = [
        [with_density(case, rho, m_add) for rho in cells.densities]
        for m_add in cells.density_added_mass_ratios
    ]
    measured, swept = _measure_all([grid, sweep])
    curve = np.geomspace(min(cells.mass_ratios), max(cells.mass_ratios), cells.curve_points)
    predicted = [
        [predict(with_ratios(case, float(m_f), m_add)) for m_f in curve]
        for m_add in cells.added_mass_ratios
    ]
    data: dict[str, Any] = {
        "mass_ratio": list(cells.mass_ratios),
        "added_mass_ratio": list(cells.added_mass_ratios),
        "density": list(cells.densities),
        "density_added_mass_ratio": list(cells.density_added_mass_ratios),
        "mean_iterations": _table(measured, 0),
        "contraction": _table(measured, 1),
        "steps": _table(measured, 2),
        "status": _table(measured, 3),
        "predicted_iterations": [[predict(cell) for cell in row] for row in grid],
        "predicted_contraction": [[cell.amplification() for cell in row] for row in grid],
        "density_mean_iterations": _table(swept, 0),
        "density_predicted_contraction": [[cell.amplification() for cell in row] for row in sweep],
        "curve_mass_ratio": curve,
        "curve_iterations": predicted,
        "integrator": list(INTEGRATORS),
        "observed_order": [observed_order(case, name) for name in INTEGRATORS],
    }
    return build(ITERATIONS, data)


def _measure_all(tables: list[list[list[PistonCase]]]) -> list[list[list[Any]]]:
    """Measure every case of every table; the slowest cells start first."""
    cases = [case for table in tables for row in table for case in row]
    values = iter(spread(measure, ((case,) for case in cases), "piston", cost=_slowness))
    return [[[next(values) for _ in row] for row in table] for table in tables]


def _slowness(case: PistonCase) -> float:
    """The nearer |G| to one, the more iterations."""
    return -abs(abs(case.amplification()) - 1)


def _table(measured: list[list[Any]], entry: int) -> Vector:
    return np.array([[cell[entry] for cell in row] for row in measured])
