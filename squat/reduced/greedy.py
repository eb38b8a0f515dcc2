"""Offline: choose positions greedily, solve there, project.

Each round solves the full problem where the bound of the energy-norm error is largest, and adds
its solutions to the basis. Beside these solves there are those for the Riesz representers, all
with one kept factor.
"""

from collections.abc import Iterator
from dataclasses import dataclass, field, replace
from typing import NamedTuple

import numpy as np
from pydantic.dataclasses import dataclass as checked
from scipy import sparse

from squat.fem import AffineStiffness, Factorised, HullLoads, flux
from squat.fluid.added_mass import DIRICHLET
from squat.fluid.added_mass import FreeSurface as Lid
from squat.fluid.model import FreeSurface
from squat.fluid.stiffness import MovingSolver
from squat.mesh import Mesh
from squat.mesh.motion import Index
from squat.progress import progress
from squat.quantities import STRICT, Count, Fraction, Vector
from squat.reduced.box import Box, BoxSize
from squat.reduced.galerkin import Affine, Galerkin
from squat.reduced.model import Floor, ReducedModel, eigenvalues, with_current
from squat.reduced.riesz import OrthonormalBasis, Representers
from squat.reduced.terms import ShortForm


class FullForm(NamedTuple):
    """The full problem: its few matrices K_m, its load vectors, and the positions of training."""

    affine: AffineStiffness
    matrices: list[sparse.csc_array]
    loads: Vector
    short: ShortForm
    positions: list[Vector]
    training: Affine
    alpha: Vector


@dataclass(eq=False)
class Builder:
    """Grows the reduced system of one Dirichlet set."""

    form: FullForm
    flows: Index
    fixed: Index
    reference: Vector
    rounding: list[list[float]] = field(default_factory=list)
    basis: OrthonormalBasis = field(init=False)
    representers: Representers = field(init=False)

    def __post_init__(self) -> None:
        X = self._matrix(self.reference)
        self.basis = OrthonormalBasis.empty(X)
        self.representers = Representers.of(Factorised.of(X, self.fixed))
        self.representers.add(self.form.loads)

    def _matrix(self, theta: Vector) -> sparse.csc_array:
        terms = zip(theta, self.form.matrices, strict=True)
        return sparse.csc_array(sum(t * K for t, K in terms))

    def extend(self, at: Affine) -> None:
        """Solve the full problem at one position and add what is new."""
        loads = at.loads[self.flows] @ self.form.loads
        K = self._matrix(at.theta)
        solver = MovingSolver(self.form.affine, self.fixed)
        theta = self.form.short.weights @ at.theta
        solutions = [solver.solve(theta, load) for load in loads]
        self.rounding.append(
            [
                _rounding(abs(K), abs(phi), phi @ load)
                for phi, load in zip(solutions, loads, strict=True)
            ]
        )
        for phi in solutions:
            old = len(self.basis.vectors)
            self.basis.add(phi)
            for v in self.basis.vectors[old:]:
                self.representers.add(np.array([K @ v for K in self.form.matrices]))

    def system(self) -> Galerkin:
        """The reduced system as it stands."""
        V = self.basis.vectors
        terms = self.form.affine.project(V)
        stiffness = np.tensordot(self.form.short.weights.T, terms, axes=1)
        return Galerkin(self.flows, stiffness, self.form.loads @ V.T, self.representers.table())

    def errors(self) -> Vector:
        """Relative energy-norm bound of the worst flow at each training position."""
        system, at = self.system(), self.form.training
        u = system.solve(at)
        energy = np.diagonal(system.energy(at, u), axis1=1, axis2=2)
        norms = system.residual_norms(at, u)
        return np.asarray((norms / np.sqrt(energy * self.form.alpha[:, None])).max(axis=1))


def _rounding(size: sparse.csc_array, phi: Vector, energy: float) -> float:
    """Relative rounding error of an energy, as of independent roundings of its terms.

    eps | |phi| |K| |phi| |_2 / (phi^T K phi): phi is large where its gradient is small.
    """
    terms = phi * (size @ phi)
    return float(np.finfo(float).eps * np.linalg.norm(terms) / energy)


@checked(frozen=True, kw_only=True, config=STRICT)
class Training:
    """How a reduced model is made (`conf/reduced/`).

    Parameters
    ----------
    box
        Positions that it answers for.
    tolerance
        Bound of the fields' relative energy-norm error at which the choice ends.
    positions
        Most positions at which the full problem is solved.
    """

    box: BoxSize
    tolerance: Fraction
    positions: Count


class Round(NamedTuple):
    """One round of the choice: the position solved at, the size N and worst bound after it."""

    position: Vector
    size: int
    worst: float


class Reduced(NamedTuple):
    """A reduced model, its basis functions (N of each system, nodes), and how it came about."""

    model: ReducedModel
    basis: tuple[Vector, ...]
    rounds: list[Round]


def reduce(mesh: Mesh, density: float, free_surface: FreeSurface, training: Training) -> Reduced:
    """Reduced model of the potential flows on `mesh`.

    Parameters
    ----------
    mesh
        Fine mesh whose submesh moves in the modes of the box.
    density
        rho [kg/m3].
    """
    box = Box(mesh.submesh, training.box)
    mesh = replace(mesh, submesh=box.limited())
    affine = AffineStiffness.on(mesh)
    form = full_form(affine, box)
    builders = [
        Builder(
            form,
            flows,
            affine.space.dofs(*DIRICHLET[lid]),
            affine.theta(box.middle)[form.short.chosen],
        )
        for flows, lid in dirichlet_sets(free_surface, len(box.size.modes))
    ]
    label = f"reduced model of a mesh of {len(mesh.points)} nodes: flow solved at position"
    rounds = list(progress(_rounds(form, builders, training), training.positions, label))
    systems = tuple(builder.system() for builder in builders)
    model = ReducedModel(
        box, density, free_surface, form.short.chosen, systems, _floor(box, builders, rounds)
    )
    nodes = affine.space.basis.nodal_dofs[0]
    return Reduced(model, tuple(b.basis.vectors[:, nodes] for b in builders), rounds)


def _floor(box: Box, builders: list[Builder], rounds: list[Round]) -> Floor:
    """Rounding of the full energies at the positions that were solved at."""
    gaps = np.array([box.clearance(found.position) for found in rounds])
    order = np.argsort(gaps)
    return Floor(gaps[order], np.hstack([builder.rounding for builder in builders])[order])


def dirichlet_sets(free_surface: FreeSurface, modes: int) -> list[tuple[Index, Lid]]:
    """Flows that share a Dirichlet set, and the name of that set."""
    moving = np.arange(1, 1 + modes)
    if free_surface == "rigid_lid":
        return [(np.arange(1 + modes), "rigid_lid")]
    return [(np.array([0]), "rigid_lid"), (moving, "zero_pressure")]


def full_form(affine: AffineStiffness, box: Box) -> FullForm:
    """The few terms of the full problem, and the coefficients at the training positions."""
    positions = box.grid()
    edges = HullLoads(affine.mesh, affine.space)
    samples = np.array([affine.theta(q) for q in positions])
    short = ShortForm.of(samples.T)
    reference = affine.zones.at(box.middle)
    return FullForm(
        affine,
        [affine.matrix(weights) for weights in short.weights.T],
        np.vstack([flux(affine.space, "Out"), edges.terms]),
        short,
        positions,
        Affine(
            samples[:, short.chosen],
            np.array([with_current(edges.edges.at(q)) for q in positions]),
        ),
        np.array([eigenvalues(affine.zones.at(q), reference).min() for q in positions]),
    )


def _rounds(form: FullForm, builders: list[Builder], training: Training) -> Iterator[Round]:
    """Rounds of the greedy choice, up to the tolerance or the last position allowed."""
    place = int(np.argmin(np.abs(form.alpha - 1)))
    for _ in range(training.positions):
        for builder in builders:
            builder.extend(Affine(form.training.theta[place], form.training.loads[place]))
        errors = np.max([builder.errors() for builder in builders], axis=0)
        size = sum(len(builder.basis.vectors) for builder in builders)
        yield Round(form.positions[place], size, float(errors.max()))
        place = int(np.argmax(errors))
        if errors[place] <= training.tolerance:
            return
