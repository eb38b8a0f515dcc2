"""One coupled run as a whole: ship, channel, current, and how to couple and integrate."""

import math
from typing import Annotated, Literal

import numpy as np
from pydantic import Field
from pydantic.dataclasses import dataclass

from squat.channel import AnyHull, Channel
from squat.dynamics.hydrostatics import heave_stiffness
from squat.errors import InputError
from squat.fluid.accuracy import Accuracy
from squat.fluid.model import FreeSurface
from squat.mesh import MODES, MeshSize
from squat.quantities import STRICT, Angle, Fraction, NonNegative, Position, Speed, Vector, Velocity
from squat.reduced import Training
from squat.transient.options import CouplingChoice, Duration, Force, Inputs, Restart
from squat.water import Water

Model = Literal["full", "curves", "reduced"]
Mode = Literal["surge", "heave", "pitch"]


@dataclass(frozen=True, kw_only=True, config=STRICT)
class TransientCase:
    """The ship of section 3.6, or another, set free in a current.

    Parameters
    ----------
    current
        V_inf [m/s].
    force
        `pressure`: the integral of Eq. (15); `variational`: that of the energies, which a step of
        energy_momentum, and curves, need (docs/theory/energy.md).
    model
        `full`: the flow is solved at every position; `curves`: a, b, c as series made from a few
        solves before the run; no field, no pressure on the hull; `reduced`: a reduced basis from
        a few solves before the run, with pressure and field (docs/theory/reduced.md).
    reduced
        How a reduced model is made where `inputs.reduced` gives none.
    modes
        Motions of the ship, heave among them, in the order surge, heave, pitch.
    held
        Those of `modes` that keep the velocity they start with: prescribed motion.
    initial_surge, initial_heave, initial_pitch
        Position at t = 0 [m], [m], [rad, positive bow down] of the modes that there are.
    surge_velocity
        Surge velocity at t = 0 [m/s]; all others are zero.
    mooring
        Stiffness of a spring on surge, per metre of width [N/m2].
    grounding
        Least clearance over that at rest; closer, a converged step counts as grounded.
    snapshots
        Steps between two snapshots of the whole field; 0: none.
    """

    hull: AnyHull
    channel: Channel
    water: Water
    mesh: MeshSize
    accuracy: Accuracy
    current: Speed
    free_surface: FreeSurface
    force: Force
    model: Model
    reduced: Training
    time: Duration
    coupling: CouplingChoice
    modes: tuple[Mode, ...]
    held: tuple[Mode, ...]
    initial_surge: Position
    initial_heave: Position
    initial_pitch: Angle
    surge_velocity: Velocity
    mooring: NonNegative
    grounding: Fraction
    snapshots: Annotated[int, Field(strict=True, ge=0)]
    restart: Restart
    inputs: Inputs

    def __post_init__(self) -> None:
        if self.force == "pressure" and self.model == "curves":
            raise InputError(f"model={self.model}: has no pressure; give force=variational")
        if self.force == "pressure" and self.coupling.conserving:
            raise InputError(
                "coupling.integrator=energy_momentum: needs the energies of ship and water; "
                "give force=variational"
            )
        if self.model == "curves" and self.snapshots:
            raise InputError(f"snapshots={self.snapshots}: model={self.model} has no field; give 0")
        if self.model == "curves" and len(self.modes) > 1:
            raise InputError("model=curves: holds heave alone; give model=full, or modes=[heave]")
        if self.inputs.reduced is not None and self.model != "reduced":
            raise InputError(
                f"inputs.reduced={self.inputs.reduced}: model={self.model} has no use for it; "
                "give model=reduced"
            )
        self._check_modes()

    def _check_modes(self) -> None:
        if "heave" not in self.modes or list(self.modes) != [m for m in MODES if m in self.modes]:
            raise InputError(
                f"modes={list(self.modes)}: give heave, alone or with others, in the order "
                f"{', '.join(MODES)}"
            )
        for mode in self.held:
            if mode not in self.modes:
                raise InputError(f"held={list(self.held)}: {mode} is not in modes; add it there")
        if self.held and self.coupling.conserving:
            raise InputError(
                f"held={list(self.held)}: what holds a mode does work, and "
                "coupling.integrator=energy_momentum keeps the energy; leave the mode out"
            )
        for key, mode, value in (
            ("initial_surge", "surge", self.initial_surge),
            ("surge_velocity", "surge", self.surge_velocity),
            ("mooring", "surge", self.mooring),
            ("initial_pitch", "pitch", self.initial_pitch),
        ):
            if value and mode not in self.modes:
                raise InputError(f"{key}={value:g}: {mode} is not in modes; add it there")

    @property
    def start(self) -> tuple[Vector, Vector]:
        """q and q' at t = 0, shape (n,) each."""
        position = {
            "surge": self.initial_surge,
            "heave": self.initial_heave,
            "pitch": self.initial_pitch,
        }
        q = np.array([position[mode] for mode in self.modes])
        return q, np.array([self.surge_velocity * (mode == "surge") for mode in self.modes])

    @property
    def place(self) -> int:
        """Place of heave in `modes`."""
        return self.modes.index("heave")

    @property
    def mass(self) -> float:
        """Ship mass per unit width [kg/m]."""
        return self.water.density * self.hull.outline.area

    def omega(self, added_mass: float) -> float:
        """Eq. (5) with rho g L for 2 rho g S: angular frequency [rad/s] of the time scale."""
        stiffness = heave_stiffness(self.water, self.hull.outline.length)
        return math.sqrt(stiffness / (self.mass + added_mass))
