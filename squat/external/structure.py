"""The user's structure."""

from dataclasses import dataclass
from typing import Protocol

import numpy as np
from numpy.typing import ArrayLike

from squat.dynamics import Kinematics, Motion
from squat.errors import InputError
from squat.quantities import Vector


class StructureModel(Protocol):
    """What `couple` asks of a structure of n degrees of freedom, M q'' = force + fluid."""

    @property
    def mass(self) -> Vector:
        """M, shape (n, n)."""
        ...

    def force(self, motion: Motion, time: float) -> Vector:
        """Everything on the right but the fluid, shape (n,): springs, dampers, loads."""
        ...

    def tangent(self, kinematics: Kinematics) -> Vector:
        """-d force/dq'' with q and q' tied to q'' by one time step, shape (n, n); zeros will do.

        With it the structure's own springs are solved implicitly, as its solver would.
        """
        ...


@dataclass(frozen=True)
class Structure:
    """M q'' + D q' + K q = load + fluid; numbers for one degree of freedom, else (n, n) and (n,).

    Raises
    ------
    InputError
        Where shapes do not fit, or M is singular.
    """

    mass: Vector
    damping: Vector
    stiffness: Vector
    load: Vector

    def __init__(
        self,
        mass: ArrayLike,
        damping: ArrayLike = 0.0,
        stiffness: ArrayLike = 0.0,
        load: ArrayLike = 0.0,
    ) -> None:
        matrix = np.atleast_2d(np.asarray(mass, float))
        size = len(matrix)
        given = {"mass": matrix, "damping": damping, "stiffness": stiffness}
        for name, value in given.items():
            object.__setattr__(self, name, _shaped(name, value, (size, size)))
        object.__setattr__(self, "load", _shaped("load", load, (size,)))
        if np.linalg.matrix_rank(self.mass) < size:
            raise InputError(f"mass={np.array2string(matrix)}: singular; give every freedom a mass")

    def force(self, motion: Motion, time: float) -> Vector:
        """Load less damping and spring forces, shape (n,)."""
        return np.asarray(
            self.load - self.damping @ motion.velocity - self.stiffness @ motion.position
        )

    def tangent(self, kinematics: Kinematics) -> Vector:
        """(s1/s3) dt D + (dt^2/s3) K, shape (n, n)."""
        s1, s3, dt = kinematics.s1, kinematics.s3, kinematics.dt
        return np.asarray(s1 / s3 * dt * self.damping + dt**2 / s3 * self.stiffness)


def _shaped(name: str, value: ArrayLike, shape: tuple[int, ...]) -> Vector:
    """`value` as a finite array of `shape`; one number fills zeros, or the one entry."""
    array = np.asarray(value, float)
    if array.ndim == 0 and (array == 0 or shape in ((1,), (1, 1))):
        array = np.full(shape, float(array))
    if array.shape != shape or not np.isfinite(array).all():
        raise InputError(f"{name}: must be finite numbers of shape {shape}, not {array.shape}")
    return array
