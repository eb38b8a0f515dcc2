"""How fine a mesh is, and where."""

from typing import Annotated, Literal

from pydantic import Field
from pydantic.dataclasses import dataclass

from squat.errors import InputError
from squat.quantities import STRICT, Length


@dataclass(frozen=True, kw_only=True, config=STRICT)
class MeshSize:
    """Edge length h as a function of the distance d from the hull and r from its corners.

    h = min(near + slope d, far), and where `grading` g > 0 also
    h <= near (max(r, r0) / corner_radius)^g, with r0 = h(r0) the size of the smallest triangles.

    Parameters
    ----------
    near
        h on the hull [m].
    far
        Largest h [m].
    slope
        Growth of h with the distance from the hull [m/m].
    grading
        g in [0, 1); 0: none. P1 elements are of optimal order at the corner of a box, where the
        energy density goes like r^(-2/3), for g > 1/3; P2 for g > 2/3.
    corner_radius
        Distance [m] from a corner within which grading acts.
    order
        Of the elements that will be put on the triangles: 1 or 2.
    max_nodes
        A mesh that would have more nodes is refused before it is made.
    """

    near: Length
    far: Length
    slope: Annotated[float, Field(strict=True, gt=0, le=10)]
    grading: Annotated[float, Field(strict=True, ge=0, lt=1)]
    corner_radius: Length
    order: Literal[1, 2]
    max_nodes: Annotated[int, Field(strict=True, ge=1, le=10**8)] = 500_000

    def __post_init__(self) -> None:
        if self.far < self.near:
            raise InputError(f"mesh.far={self.far:g}: must be at least mesh.near={self.near:g}")
        if self.grading and self.near >= self.corner_radius:
            raise InputError(
                f"mesh.near={self.near:g}: must be less than "
                f"mesh.corner_radius={self.corner_radius:g} for mesh.grading={self.grading:g}"
            )

    @property
    def smallest(self) -> float:
        """h at the corners [m]: where r = h(r)."""
        g = self.grading
        return float((self.near / self.corner_radius**g) ** (1 / (1 - g)))
