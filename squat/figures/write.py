"""Draw a figure by name and write it as PNG and SVG."""

from collections.abc import Callable
from pathlib import Path

import matplotlib as mpl
from matplotlib.figure import Figure
from pydantic.dataclasses import dataclass

from squat import records
from squat.errors import InputError
from squat.figures.added_mass import fig7, fig9, sensitivity
from squat.figures.domain import fig3, fig8
from squat.figures.energy import energy_audit
from squat.figures.equilibria import fig10
from squat.figures.files import save
from squat.figures.fleet import stability_map
from squat.figures.hull_shapes import hull_shapes
from squat.figures.iterations import iterations
from squat.figures.limits import basins, limits, limits_map
from squat.figures.mesh import fig5, fig6, mesh_quality
from squat.figures.race import race
from squat.figures.stability import phase_portrait, potential
from squat.figures.style import SETTINGS
from squat.figures.transient import fig11, fig12, fig13
from squat.figures.trim import trim
from squat.figures.uneven import uneven_bottom
from squat.quantities import STRICT
from squat.records.added_mass_kinds import ADDED_MASS, INERTIA, SENSITIVITY
from squat.records.bottom_kinds import UNEVEN_BOTTOM
from squat.records.coupling_kinds import RACE
from squat.records.fleet_kinds import STABILITY_MAP
from squat.records.mesh_kinds import MESH
from squat.records.piston_kinds import ITERATIONS
from squat.records.schema import Kind
from squat.records.stability_kinds import EQUILIBRIA, HULL_SHAPES, LIMITS_MAP, STABILITY
from squat.records.transient_kinds import TRANSIENT
from squat.records.trim_kinds import TRIM

FIGURES: dict[str, tuple[Kind, Callable[..., Figure]]] = {
    "fig10": (EQUILIBRIA, fig10),
    "iterations": (ITERATIONS, iterations),
    "fig3": (MESH, fig3),
    "fig5": (MESH, fig5),
    "fig6": (MESH, fig6),
    "fig8": (MESH, fig8),
    "mesh_quality": (MESH, mesh_quality),
    "fig7": (ADDED_MASS, fig7),
    "fig9": (INERTIA, fig9),
    "sensitivity": (SENSITIVITY, sensitivity),
    "fig11": (TRANSIENT, fig11),
    "fig12": (TRANSIENT, fig12),
    "fig13": (TRANSIENT, fig13),
    "stability_map": (STABILITY_MAP, stability_map),
    "energy_audit": (TRANSIENT, energy_audit),
    "potential": (STABILITY, potential),
    "phase_portrait": (STABILITY, phase_portrait),
    "limits": (STABILITY, limits),
    "basins": (STABILITY, basins),
    "limits_map": (LIMITS_MAP, limits_map),
    "hull_shapes": (HULL_SHAPES, hull_shapes),
    "race": (RACE, race),
    "trim": (TRIM, trim),
    "uneven_bottom": (UNEVEN_BOTTOM, uneven_bottom),
}
_MOST = {"fig11": 8, "fig13": 3, "energy_audit": 7}
"""Runs up to which these draw several, told apart by rows, dashes and colours; the others one."""


@dataclass(frozen=True, kw_only=True, config=STRICT)
class FigureCase:
    """Which figure, from which dataset.

    Parameters
    ----------
    figure
        Name of one of `FIGURES`.
    data
        Path of the dataset, or of several where the figure compares runs, up to `_MOST`.
    """

    figure: str
    data: str | tuple[str, ...]

    def __post_init__(self) -> None:
        if self.figure not in FIGURES:
            raise InputError(
                f"figure={self.figure}: unknown; give one of {', '.join(FIGURES)}; "
                "squat task=figure figure=list tells what each shows"
            )
        count, most = len(self.paths), _MOST.get(self.figure, 1)
        if not 1 <= count <= most:
            runs, remedy = ("one run", "one file") if most == 1 else (f"1 to {most} runs", "those")
            raise InputError(
                f"figure={self.figure}: draws {runs}, data names {count}; give {remedy}"
            )

    @property
    def paths(self) -> tuple[str, ...]:
        """The datasets."""
        return (self.data,) if isinstance(self.data, str) else self.data


def catalogue() -> str:
    """One line a figure: its name, its dataset's task, what it shows, and if of several files."""
    return "\n".join(
        f"{name:<15} {kind.name:<13} {(draw.__doc__ or '').partition(chr(10))[0]}"
        + (f" [data: 1 to {_MOST[name]} files]" if name in _MOST else "")
        for name, (kind, draw) in FIGURES.items()
    )


def write_figure(case: FigureCase, path: Path) -> None:
    """Write the figure to `path` (.png) and beside it as .svg."""
    kind, draw = FIGURES[case.figure]
    with mpl.rc_context(SETTINGS):
        figure = draw(*(records.read(Path(name), kind) for name in case.paths))
        save(figure, path)
