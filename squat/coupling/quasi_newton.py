"""Accelerators that model the residual's Jacobian from differences of iterates.

With r^k = q~^k - q^k, where q~^k is the structure's answer to the trial q^k, and columns
V = [changes of r], W = [changes of q~], both newest first, all of them solve

    min_c |V c + r^k|,      q^{k+1} = q~^k + W c

or its damped form. For one degree of freedom this is the secant method.
"""

from typing import Annotated, Literal, NamedTuple

import numpy as np
from numpy.typing import NDArray
from pydantic import Field
from pydantic.dataclasses import dataclass

from squat.dynamics import Kinematics, Motion
from squat.quantities import STRICT, Count, Fraction, Vector


class Secants(NamedTuple):
    """What a step's iterations taught, newest first; it survives the step in `State.learned`.

    residuals, answers (m, n): changes of r and of q~; steps (m,): how many steps ago.
    """

    residuals: Vector
    answers: Vector
    steps: Vector

    @staticmethod
    def none(size: int) -> "Secants":
        """No column of `size` degrees of freedom."""
        return Secants(np.empty((0, size)), np.empty((0, size)), np.empty(0))

    def before(self, older: "Secants") -> "Secants":
        """These columns followed by `older` ones."""
        return Secants(*(np.concatenate(pair) for pair in zip(self, older, strict=True)))

    def chosen(self, rows: list[int] | NDArray[np.bool_]) -> "Secants":
        """The columns that an index or a mask picks."""
        return Secants(*(part[rows] for part in self))


def independent(columns: Vector, limit: float) -> list[int]:
    """Indices of the rows of `columns` (m, n) that earlier rows do not nearly span.

    A row is left out where what orthogonalisation leaves of it is shorter than `limit` times the
    row: the "QR2" filter of Haelterman et al., Comput. Struct. 171 (2016) 9-17, newest first.
    """
    kept: list[int] = []
    basis = np.empty((0, columns.shape[1]))
    for index, column in enumerate(columns):
        rest = column - basis.T @ (basis @ column)
        rest = rest - basis.T @ (basis @ rest)  # once more, against rounding
        length = float(np.linalg.norm(rest))
        if length > limit * float(np.linalg.norm(column)):
            kept.append(index)
            basis = np.vstack([basis, rest / length])
    return kept


def conditioned(columns: Vector, limit: float) -> bool:
    """Whether the condition number of the rows (m, n) is at most `limit`; false with a zero row."""
    values = np.linalg.svd(columns, compute_uv=False)
    return bool(0 < values[0] <= limit * values[-1])


class _Iterates:
    """Trials and answers of one step, newest first."""

    def __init__(self) -> None:
        self.residuals: list[Vector] = []
        self.answers: list[Vector] = []

    def add(self, trial: Motion, answer: Motion) -> Vector:
        self.residuals.insert(0, answer.position - trial.position)
        self.answers.insert(0, answer.position)
        return self.residuals[0]

    def secants(self) -> Secants:
        changes = [-np.diff(np.array(rows), axis=0) for rows in (self.residuals, self.answers)]
        return Secants(changes[0], changes[1], np.zeros(len(changes[0])))


class _Anderson:
    def __init__(self, choice: "Anderson") -> None:
        self.choice = choice
        self.iterates = _Iterates()

    def next(self, trial: Motion, answer: Motion, kinematics: Kinematics) -> Motion:
        residual = self.iterates.add(trial, answer)
        mixed = trial.position + self.choice.mixing * residual
        count = min(self.choice.depth, residual.size, len(self.iterates.answers) - 1)
        changes, answers, _ = self.iterates.secants().chosen(list(range(count)))
        while len(changes) > 1 and not conditioned(changes, self.choice.condition):
            changes, answers = changes[:-1], answers[:-1]
        if len(changes):
            weights = np.linalg.lstsq(changes.T, residual)[0]
            mixed = mixed - weights @ (answers - (1 - self.choice.mixing) * changes)
        return kinematics.at_position(mixed)

    def learned(self) -> None:
        return None


class _LeastSquares:
    def __init__(self, choice: "InterfaceQuasiNewton", older: Secants | None) -> None:
        self.choice = choice
        self.older = older
        self.iterates = _Iterates()

    def next(self, trial: Motion, answer: Motion, kinematics: Kinematics) -> Motion:
        residual = self.iterates.add(trial, answer)
        known = self._known()
        changes, answers, _ = known.chosen(independent(known.residuals, self.choice.filter))
        if not len(changes):
            return kinematics.at_position(trial.position + self.choice.initial * residual)
        weights = np.linalg.lstsq(changes.T, -residual)[0]
        return kinematics.at_position(answer.position + weights @ answers)

    def _known(self) -> Secants:
        new = self.iterates.secants()
        return new if self.older is None else new.before(self.older)

    def learned(self) -> Secants | None:
        if self.choice.reuse == 0:
            return None
        known = self._known()
        aged = known._replace(steps=known.steps + 1)
        recent = aged.chosen(aged.steps <= self.choice.reuse)
        return recent.chosen(independent(recent.residuals, self.choice.filter))


@dataclass(frozen=True, kw_only=True, config=STRICT)
class Anderson:
    """q^{k+1} = q^k + b r^k - (dQ + b dR) c, c = argmin |r^k - dR c|, over the last changes.

    Type II of Walker and Ni, SIAM J. Numer. Anal. 49 (2011) 1715-1735; b is `mixing`, dQ and dR are
    the last `depth` changes of trial and residual. The oldest are dropped until dR is conditioned.

    Parameters
    ----------
    depth
        Greatest number of changes; never more than degrees of freedom are used.
    mixing
        b in (0, 1].
    condition
        Greatest condition number of dR.
    """

    name: Literal["anderson"]
    depth: Count
    mixing: Fraction
    condition: Annotated[float, Field(gt=1, le=1e16)]

    def start(self, learned: Secants | None) -> _Anderson:
        """Updates of a new time step; nothing is reused."""
        return _Anderson(self)


@dataclass(frozen=True, kw_only=True, config=STRICT)
class InterfaceQuasiNewton:
    """q^{k+1} = q~^k + W c, c = argmin |V c + r^k|: IQN-ILS with reuse of earlier steps' columns.

    Source: Degroote, Bathe and Vierendeels, Comput. Struct. 87 (2009) 793-801. Columns that newer
    ones nearly span are left out (`independent`).

    Parameters
    ----------
    initial
        Relaxation factor while no column is known, in (0, 1].
    reuse
        Earlier time steps whose columns are kept; 0: none.
    filter
        Least part of a column, in (0, 1), that newer columns must leave.
    """

    name: Literal["iqn_ils"]
    initial: Fraction
    reuse: Annotated[int, Field(strict=True, ge=0, le=1000)]
    filter: Annotated[float, Field(gt=0, lt=1)]

    def start(self, learned: Secants | None) -> _LeastSquares:
        """Updates of a new time step, from what the last ones `learned`."""
        return _LeastSquares(self, learned)
