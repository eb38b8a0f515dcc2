"""Limits of any hull in any channel, on all meshes of an accuracy."""

from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

from squat.fluid.accuracy import Accuracy, Estimate
from squat.stability.dynamic import dynamic_squat_speed
from squat.stability.equilibria import Fold, OneDimensionalModel
from squat.stability.fold import squat_speed
from squat.stability.heave import HeaveSystem
from squat.stability.sampling import Ship, estimate


class Limits(NamedTuple):
    """Limits [m/s] of a ship in a channel, with errors, and the sinkages at the first two [m]."""

    limit_1d: float
    limit_2d: float
    limit_2d_error: float
    limit_dynamic: float
    limit_dynamic_error: float
    sinkage_1d: float
    sinkage_2d: float


@dataclass(frozen=True)
class Sampled:
    """A ship on the meshes of an accuracy, each made once.

    Parameters
    ----------
    ship
        Hull, channel, water.
    accuracy
        Meshes, and how their values are extrapolated.
    """

    ship: Ship
    accuracy: Accuracy

    @cached_property
    def levels(self) -> list[HeaveSystem]:
        """The ship on each mesh, the coarsest first."""
        return self.ship.levels(self.accuracy)

    @cached_property
    def folds(self) -> list[Fold]:
        """Its 2D squat speed on each mesh."""
        return [squat_speed(level.at_current) for level in self.levels]

    def estimate(self, values: list[float]) -> Estimate:
        """One number from its values on the meshes."""
        return estimate(values, self.accuracy)

    def limits(self, heave: float, velocity: float) -> Limits:
        """1D, 2D and, set free at `heave` [m] with `velocity` [m/s], dynamic limit."""
        ship = self.ship
        one = OneDimensionalModel(ship.hull, ship.channel, ship.water).squat_speed()
        speed = self.estimate([fold.speed for fold in self.folds])
        dynamic = [
            dynamic_squat_speed(level.at_current, fold, heave, velocity)
            for level, fold in zip(self.levels, self.folds, strict=True)
        ]
        lost = self.estimate(dynamic)
        values = one.speed, *speed, *lost, one.sinkage, self.folds[-1].sinkage
        return Limits(*(float(value) for value in values))
