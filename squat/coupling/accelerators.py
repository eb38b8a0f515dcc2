"""The next trial motion from the structure's answer to the last one."""

from typing import Literal, Protocol

from pydantic.dataclasses import dataclass

from squat.coupling.monolithic import Monolithic
from squat.coupling.quasi_newton import Anderson, InterfaceQuasiNewton, Secants
from squat.dynamics import Kinematics, Motion
from squat.quantities import STRICT, Fraction, Vector


class Updates(Protocol):
    """One step's sequence of updates: may remember earlier iterations."""

    def next(self, trial: Motion, answer: Motion, kinematics: Kinematics) -> Motion:
        """Trial of the next iteration."""
        ...

    def learned(self) -> Secants | None:
        """What the next steps may reuse; None: nothing."""
        ...


class _Forgetful:
    def learned(self) -> None:
        return None


class _Plain(_Forgetful):
    def next(self, trial: Motion, answer: Motion, kinematics: Kinematics) -> Motion:
        return answer


class _Relaxed(_Forgetful):
    def __init__(self, factor: float) -> None:
        self.factor = factor

    def next(self, trial: Motion, answer: Motion, kinematics: Kinematics) -> Motion:
        return kinematics.at_position(
            trial.position + self.factor * (answer.position - trial.position)
        )


class _Aitken(_Forgetful):
    def __init__(self, initial: float) -> None:
        self.factor = initial
        self.residual: Vector | None = None

    def next(self, trial: Motion, answer: Motion, kinematics: Kinematics) -> Motion:
        residual = answer.position - trial.position
        if self.residual is not None:
            change = residual - self.residual
            if (size := float(change @ change)) > 0:
                self.factor *= -float(self.residual @ change) / size
        self.residual = residual
        return kinematics.at_position(trial.position + self.factor * residual)


@dataclass(frozen=True, kw_only=True, config=STRICT)
class NoAcceleration:
    """q^{k+1} is the structure's answer itself (Algorithms 1 and 2)."""

    name: Literal["none"]

    def start(self, learned: Secants | None) -> Updates:
        """Updates of a new time step."""
        return _Plain()


@dataclass(frozen=True, kw_only=True, config=STRICT)
class ConstantRelaxation:
    """q^{k+1} = q^k + factor r^k with r^k the structure's answer less q^k.

    Parameters
    ----------
    factor
        Relaxation factor in (0, 1].
    """

    name: Literal["relaxation"]
    factor: Fraction

    def start(self, learned: Secants | None) -> Updates:
        """Updates of a new time step."""
        return _Relaxed(self.factor)


@dataclass(frozen=True, kw_only=True, config=STRICT)
class Aitken:
    """Dynamic relaxation: omega_{k+1} = -omega_k r^{k-1}.(r^k - r^{k-1}) / |r^k - r^{k-1}|^2.

    Source: Kuettler and Wall, Comput. Mech. 43 (2008) 61-72.

    Parameters
    ----------
    initial
        Relaxation factor of a step's first iteration, in (0, 1].
    """

    name: Literal["aitken"]
    initial: Fraction

    def start(self, learned: Secants | None) -> Updates:
        """Updates of a new time step."""
        return _Aitken(self.initial)


Iterative = NoAcceleration | ConstantRelaxation | Aitken | Anderson | InterfaceQuasiNewton
Accelerator = Iterative | Monolithic
