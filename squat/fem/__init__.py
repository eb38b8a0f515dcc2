"""Finite elements: stiffness in affine form, loads of rigid motion, solves with a residual."""

from squat.fem.affine import AffineStiffness
from squat.fem.loads import EdgeLoads, HullLoads, edge_normals, flux
from squat.fem.solve import Factorised, Solution, SolveError
from squat.fem.space import Space

__all__ = [
    "AffineStiffness",
    "EdgeLoads",
    "Factorised",
    "HullLoads",
    "Solution",
    "SolveError",
    "Space",
    "edge_normals",
    "flux",
]
