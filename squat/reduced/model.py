"""The reduced energy of the water: a, b, c and their slopes at microseconds, with bounds.

Galerkin on the affine form is consistent: the slopes are the exact derivatives of the reduced
energies, so a ship coupled to them keeps its energy as the full one does.
"""

from collections.abc import Callable
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any, NamedTuple, TypeVar, cast

import numpy as np

from squat.fem import EdgeLoads
from squat.fem.affine import ZoneMetrics, flat
from squat.fluid.model import Coefficients, FreeSurface, Slopes
from squat.mesh import PositionError, Submesh
from squat.mesh.motion import Index
from squat.quantities import Vector
from squat.reduced.box import Box
from squat.reduced.galerkin import Affine, Galerkin

Parts = TypeVar("Parts", Coefficients, Slopes)


class Solved(NamedTuple):
    """What was found at one position: coefficients, and u of each Dirichlet set."""

    at: Affine
    u: tuple[Vector, ...]


class Floor(NamedTuple):
    """Relative rounding of the full energies at some clearances [m], ascending, shape (k,).

    share (k, flows): eps | |phi| |K| |phi| |_2 / (phi^T K phi), one standard deviation.
    """

    clearance: Vector
    share: Vector

    def at(self, gap: float) -> Vector:
        """Four standard deviations at clearance `gap` [m], shape (flows,)."""
        x, rows = np.log(self.clearance), np.log(self.share).T
        return 4 * np.exp([np.interp(np.log(gap), x, row) for row in rows])


@dataclass(frozen=True, eq=False)
class ReducedModel:
    """Energies of the flows around one hull, per unit width: a `squat.fluid.model.EnergyModel`.

    Parameters
    ----------
    box
        Positions that it answers for.
    density
        rho [kg/m3].
    free_surface
        As for `PotentialFluid`.
    chosen
        Which coefficients of the affine form are computed, shape (terms,).
    systems
        One reduced system for each Dirichlet set: one under the lid, else two.
    floor
        What rounding leaves between full and reduced results.
    """

    box: Box
    density: float
    free_surface: FreeSurface
    chosen: Index
    systems: tuple[Galerkin, ...]
    floor: Floor
    _last: dict[str, tuple[bytes, Any]] = field(default_factory=dict, init=False, repr=False)

    @cached_property
    def submesh(self) -> Submesh:
        """Coarse triangulation, refusing positions below the box."""
        return self.box.limited()

    @cached_property
    def _zones(self) -> ZoneMetrics:
        return ZoneMetrics(self.submesh)

    @cached_property
    def _edges(self) -> EdgeLoads:
        return EdgeLoads(self.submesh)

    @cached_property
    def _reference(self) -> Vector:
        return self._zones.at(self.box.middle)

    @property
    def modes(self) -> tuple[str, ...]:
        """Degrees of freedom."""
        return self.submesh.modes

    def affine(self, position: Vector) -> Affine:
        """Coefficients at `position`; raises PositionError out of the box."""
        self._check(position)
        theta = flat(self._zones.at(position))[self.chosen]
        return Affine(theta, with_current(self._edges.at(position)))

    def rates(self, position: Vector) -> list[Affine]:
        """Derivatives of the coefficients by each q_k."""
        theta = flat(self._zones.derivatives(position))[:, self.chosen]
        loads = self._edges.derivatives(position)
        return [Affine(theta[k], with_current(loads[:, k], 0.0)) for k in range(len(self.modes))]

    def solve(self, position: Vector) -> Solved:
        """Unit flows at `position`."""
        return cast(Solved, self._remembered("solved", position, self._solve))

    def _solve(self, position: Vector) -> Solved:
        at = self.affine(position)
        return Solved(at, tuple(system.solve(at) for system in self.systems))

    def coefficients(self, position: Vector) -> Coefficients:
        """Energy coefficients a, b, c at `position`."""
        return parts(self.energies(position), Coefficients)

    def slopes(self, position: Vector) -> Slopes:
        """Their derivatives at `position`."""
        return cast(Slopes, self._remembered("slopes", position, self._slopes))

    def _slopes(self, position: Vector) -> Slopes:
        found = self.solve(position).u
        slopes = [
            self.whole([s.energy_slopes(rate, u) for s, u in zip(self.systems, found, strict=True)])
            for rate in self.rates(position)
        ]
        return parts(np.stack(slopes, axis=-1), Slopes)

    def _remembered(self, name: str, position: Vector, make: Callable[[Vector], Any]) -> Any:
        """`make(position)`, kept for the last one: energies, slopes and bounds ask in turn."""
        key = np.asarray(position, float).tobytes()
        found = self._last.get(name)
        if found is None or found[0] != key:
            found = self._last[name] = (key, make(position))
        return found[1]

    def metric_range(self, position: Vector) -> tuple[float, Vector]:
        """Bounds from the zones' metrics: coercivity alpha, and gamma_k of the slopes.

        alpha <= x^T K(q) x / x^T X x, with X = K at the box's middle: the least eigenvalue of the
        metric mapped from there. |x^T K_k x| <= gamma_k x^T K(q) x likewise.
        """
        here = self._zones.at(position)
        alpha = eigenvalues(here, self._reference).min()
        rates = self._zones.derivatives(position)
        gamma = [np.abs(eigenvalues(rate, here)).max() for rate in rates]
        return float(alpha), np.array(gamma)

    def energies(self, position: Vector) -> Vector:
        """rho phi_i^T K phi_j of all flows, the current's first, shape (1 + modes, 1 + modes)."""
        at, found = self.solve(position)
        return self.whole([s.energy(at, u) for s, u in zip(self.systems, found, strict=True)])

    def whole(self, blocks: list[Vector]) -> Vector:
        """Matrix of all flows [kg/m] from those of the systems; no energy between two systems."""
        size = 1 + len(self.modes)
        whole = np.zeros((size, size))
        for system, block in zip(self.systems, blocks, strict=True):
            whole[np.ix_(system.flows, system.flows)] = block
        return self.density * whole

    @cached_property
    def coupled(self) -> Vector:
        """1 where two flows share a Dirichlet set, else 0, shape (flows, flows)."""
        ones = [np.ones((len(system.flows),) * 2) for system in self.systems]
        return self.whole(ones) / self.density

    def _check(self, position: Vector) -> None:
        if len(position) > 1 and abs(position[1]) > self.box.size.pitch * (1 + 1e-12):
            raise PositionError(
                f"pitch={position[1]:g}: beyond the reduced model's {self.box.size.pitch:g} rad; "
                "raise reduced.box.pitch"
            )


def with_current(loads: Vector, current: float = 1.0) -> Vector:
    """Load coefficients of all flows: the current's flux in front of those of the modes."""
    modes, terms = loads.shape
    whole = np.zeros((1 + modes, 1 + terms))
    whole[0, 0] = current
    whole[1:, 1:] = loads
    return whole


def parts(whole: Vector, kind: type[Parts]) -> Parts:
    """a, b, c of the matrix of all flows."""
    return kind(whole[0, 0], whole[0, 1:], whole[1:, 1:])


def eigenvalues(G: Vector, reference: Vector) -> Vector:
    """Eigenvalues (nz, d) of the metrics `G` in the metrics `reference`, (nz, d, d)."""
    inverse = np.linalg.inv(np.linalg.cholesky(reference))
    mapped = inverse @ G @ inverse.swapaxes(1, 2)
    return np.asarray(np.linalg.eigvalsh(mapped), float)
