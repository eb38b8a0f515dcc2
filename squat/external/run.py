"""`squat.couple`: any structure and any force through the coupling loop."""

from collections.abc import Collection, Mapping, Sequence
from typing import Any, Literal, get_args

import numpy as np
import xarray as xr
from numpy.typing import ArrayLike

from squat.coupling import (
    PREDICTORS,
    Accelerator,
    Coupling,
    Criterion,
    PredictorName,
    State,
    corrected,
    march,
)
from squat.coupling.estimation import dominant_factor, effective_added_mass, first_iterates
from squat.dynamics import INTEGRATORS, IntegratorName, Kinematics, Motion
from squat.errors import InputError
from squat.external.dataset import Masses, dataset
from squat.external.problem import BlackBox, Fluid, Progress
from squat.external.structure import StructureModel
from squat.quantities import Vector

ExternalScheme = Literal["standard", "corrected", "estimated"]
SCHEMES = get_args(ExternalScheme)
_GROWTH = 1e8


def couple(
    structure: StructureModel,
    fluid: Fluid,
    *,
    position: ArrayLike,
    dt: float,
    steps: int,
    velocity: ArrayLike = 0.0,
    acceleration: ArrayLike = 0.0,
    memory: Any = None,
    scheme: ExternalScheme = "estimated",
    added_mass: ArrayLike | None = None,
    integrator: IntegratorName = "newmark",
    accelerator: Accelerator | str = "none",
    predictor: PredictorName = "quadratic",
    tolerance: float = 1e-10,
    iterations: int = 200,
    modes: Sequence[str] | None = None,
) -> xr.Dataset:
    """Couple `structure` with `fluid` for `steps` time steps of `dt`.

    Parameters
    ----------
    structure
        A `Structure`, or anything with the three members of `StructureModel`.
    fluid
        Called as ``fluid(motion, time, memory)`` with the trial motion at the step's end, it
        returns the force, shape (n,), or ``Load(force, memory)``: that memory is handed back in
        the next step if this answer is the accepted one. Within a step the memory stays.
    position, velocity, acceleration
        At t = 0; numbers or shape (n,). An acceleration that does not balance the forces there
        leaves an error of the order of dt.
    memory
        The fluid's memory at t = 0.
    scheme
        `standard`, Eq. (6); `corrected` with `added_mass`, Eq. (12); `estimated`: corrected with
        what the first iterates show.
    added_mass
        m_add of the corrected scheme, a number or (n, n).
    accelerator
        One of `squat.coupling`'s, or the name of one in conf/accelerator/.
    tolerance
        Bound on |q^{k+1} - q^k| of the accepted iterate.
    iterations
        Iteration limit of a step.
    modes
        Names of the degrees of freedom.

    Returns
    -------
    Dataset of kind `coupled` (docs/datasets.md): the history, iterations, residuals, the effective
    added mass, predicted and measured contraction; `status` says how it ended. A step that does
    not converge, or whose force is not finite, ends the run and is a result.

    Raises
    ------
    InputError
        An argument, or the force, of another kind or shape than asked for; a force forgotten.
    """
    _check({"scheme": (scheme, SCHEMES), "integrator": (integrator, INTEGRATORS)})
    _check({"predictor": (predictor, PREDICTORS)})
    if not dt > 0:
        raise InputError(f"dt={dt:g}: must be greater than 0")
    problem = BlackBox(structure, fluid)
    size = len(problem.mass)
    parts = {"position": position, "velocity": velocity, "acceleration": acceleration}
    start = Motion(*(_vector(size, name, part) for name, part in parts.items()))
    state = State((start,), Progress(0, memory))
    ties = INTEGRATORS[integrator].kinematics(state.past, dt)
    tangent = structure.tangent(ties)
    masses = _masses(problem, state, ties, predictor, scheme, added_mass)
    solve = corrected(problem.mass, masses.used + tangent)
    slots = Coupling(
        lambda motion: solve,
        INTEGRATORS[integrator],
        _named(accelerator) if isinstance(accelerator, str) else accelerator,
        PREDICTORS[predictor],
        Criterion(name="absolute", tolerance=tolerance, iterations=iterations, growth=_GROWTH),
    )
    taken = list(march(problem, slots, state, dt, steps))
    names = list(modes) if modes else [f"q{n + 1}" for n in range(size)]
    how = {
        "scheme": scheme,
        "accelerator": slots.accelerator.name,
        "integrator": integrator,
        "predictor": predictor,
        "tolerance": tolerance,
    }
    return dataset(problem, start, taken, masses, dt, names, how)


def _masses(
    problem: BlackBox,
    state: State,
    ties: Kinematics,
    predictor: PredictorName,
    scheme: ExternalScheme,
    added_mass: ArrayLike | None,
) -> Masses:
    """Added masses from the first iterates of the first step, and the factor they predict.

    Forces that are not finite show no added mass: the step then meets them with none.
    """
    if (added_mass is None) == (scheme == "corrected"):
        raise InputError(f"scheme={scheme}: give added_mass with scheme=corrected, and only there")
    trial = PREDICTORS[predictor](state.past, ties)
    tangent = problem.structure.tangent(ties)
    whole = effective_added_mass(first_iterates(problem, ties, trial, state.memory))
    effective = whole - tangent
    shown = scheme == "estimated" and np.isfinite(effective).all()
    used = effective if shown else np.zeros_like(effective)
    if added_mass is not None:
        used = np.atleast_2d(np.asarray(added_mass, float))
        if used.shape != effective.shape:
            raise InputError(f"added_mass: has shape {used.shape}; give {effective.shape}")
    return Masses(effective, used, dominant_factor(problem.mass, whole, used + tangent))


def _named(name: str) -> Accelerator:
    # Hydra takes half a second to import, which those who give an accelerator need not spend.
    from squat.config import CONF, compose  # noqa: PLC0415
    from squat.config.schema import validate  # noqa: PLC0415

    known = sorted(path.stem for path in (CONF / "accelerator").glob("*.yaml"))
    _check({"accelerator": (name, known)})
    found: Accelerator = validate(compose("piston", f"accelerator={name}")).case.accelerator
    return found


def _check(choices: Mapping[str, tuple[str, Collection[str]]]) -> None:
    for name, (choice, known) in choices.items():
        if choice not in known:
            raise InputError(f"{name}={choice}: unknown; give one of {', '.join(known)}")


def _vector(size: int, name: str, value: ArrayLike) -> Vector:
    array = np.asarray(value, float)
    if array.shape not in ((), (size,)):
        raise InputError(f"{name}: has shape {array.shape}; give a number or ({size},)")
    return np.array(np.broadcast_to(array, (size,)))
