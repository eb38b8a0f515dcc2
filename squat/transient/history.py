"""What a run leaves of its steps, and what it needs to go on from the last."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from typing import NamedTuple

import numpy as np

from squat.coupling import State, Step
from squat.dynamics import Motion
from squat.fluid.model import Flow
from squat.fluid.rates import Levels
from squat.quantities import Vector
from squat.records.padding import padded
from squat.transient.case import TransientCase
from squat.transient.ending import Ending
from squat.transient.parts import Parts
from squat.transient.snapshots import Snapshot, snapshot


class Row(NamedTuple):
    """One accepted step: motion and force of the water (n,), pressure (hull nodes,), iteration.

    A model without field leaves no pressure, shape (0,); a reduced one none until the run's end.
    """

    position: Vector
    velocity: Vector
    acceleration: Vector
    force: Vector
    pressure: Vector
    iterations: int
    contraction: float
    residuals: Vector


class Columns(NamedTuple):
    """The same of many steps, time first; residuals are padded with NaN."""

    position: Vector
    velocity: Vector
    acceleration: Vector
    force: Vector
    pressure: Vector
    iterations: Vector
    contraction: Vector
    residuals: Vector

    @staticmethod
    def of(rows: Sequence[Row]) -> "Columns":
        """Columns of `rows`, at least one."""
        *plain, residuals = zip(*rows, strict=True)
        return Columns._make([*map(np.array, plain), padded(list(residuals))])

    def rows(self) -> Iterator[Row]:
        """The steps one by one."""
        for values in zip(*self, strict=True):
            row = Row(*values)
            yield row._replace(residuals=row.residuals[: row.iterations])


class Stretch(NamedTuple):
    """Steps in a row, their snapshots by number, and the state at their end."""

    columns: Columns
    snapshots: dict[str, Snapshot]
    state: State


@dataclass
class History:
    """All steps so far; grows by one step, or by one stretch that was read back."""

    case: TransientCase
    parts: Parts
    rows: list[Row] = field(default_factory=list)
    snapshots: dict[int, Snapshot] = field(default_factory=dict)
    state: State = field(init=False)
    failed: Step | None = None

    def __post_init__(self) -> None:
        self.ending = Ending.of(self.case, self.parts)

    @property
    def steps(self) -> int:
        """Steps that were accepted."""
        return len(self.rows) - 1

    @property
    def status(self) -> str | None:
        """How the run ended; None while it goes on."""
        if self.failed is not None:
            return self._failure(self.failed)
        if self.ending.status is None and self.steps >= self.case.time.steps:
            return "completed"
        return self.ending.status

    def _failure(self, failed: Step) -> str:
        """What a step that did not converge says of the run."""
        if failed.status != "diverged":
            return failed.status
        return self.ending.ahead(self.state.motion, self.parts.dt) or failed.status

    def begin(self, state: State) -> None:
        """Take the state at t = 0."""
        self._accept(state, (0, np.nan, np.empty(0)))

    def take(self, step: Step) -> None:
        """Take one more step, accepted or not."""
        if step.status != "converged":
            self.failed = step
            return
        self._accept(step.state, (step.iterations, step.contraction, step.residuals))

    def _accept(self, state: State, iteration: tuple[int, float, Vector]) -> None:
        if self.parts.field is None and self._kept(len(self.rows)):
            self.snapshots[len(self.rows)] = snapshot(self.parts, state.motion, state.memory)
        self.state = state
        self._append(_row(self.parts, state, iteration))

    def _append(self, row: Row) -> None:
        self.rows.append(row)
        self.ending.see(row.position, row.velocity)

    def _kept(self, step: int) -> bool:
        """Whether a snapshot of `step` is wanted."""
        return bool(self.case.snapshots) and step % self.case.snapshots == 0

    def complete(self) -> None:
        """Pressure and snapshots of a run whose potential follows from its motion, at its end."""
        field, levels = self.parts.field, None
        if field is None:
            return
        for step, row in enumerate(self.rows):
            motion = Motion(*row[:3])
            levels = field.levels(motion, levels, self.parts.dt)
            self.rows[step] = row._replace(pressure=_pressure(self.parts, motion, levels))
            if self._kept(step):
                self.snapshots[step] = snapshot(self.parts, motion, levels)

    def since(self, row: int) -> Stretch:
        """The rows from number `row` on and where they lead."""
        kept = {str(n): value for n, value in self.snapshots.items() if n >= row}
        return Stretch(Columns.of(self.rows[row:]), kept, self.state)

    def extend(self, stretch: Stretch) -> None:
        """Take a stretch that was read back."""
        for row in stretch.columns.rows():
            self._append(row)
        self.snapshots.update({int(n): value for n, value in stretch.snapshots.items()})
        self.state = stretch.state


def _row(parts: Parts, state: State, iteration: tuple[int, float, Vector]) -> Row:
    motion, memory = state.motion, state.memory
    unknown = memory is None or parts.field is not None
    pressure = np.empty(0) if unknown else _pressure(parts, motion, memory)
    return Row(*motion, parts.problem.water_force(motion, memory), pressure, *iteration)


def _pressure(parts: Parts, motion: Motion, levels: Levels) -> Vector:
    flow = Flow(motion.position, motion.velocity, levels.now)
    return parts.fluid.pressure.nodal(flow, levels.rate, parts.fluid.current)
