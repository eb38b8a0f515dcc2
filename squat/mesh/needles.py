"""Whether a mesh has triangles too flat to be trusted."""

import logging

from squat.mesh.mesh import Mesh
from squat.mesh.quality import quality

_log = logging.getLogger(__name__)
_NEEDLE = 0.01
"""Quality at rest that no ready-made hull comes near."""


def told(*meshes: Mesh, whose: str = "") -> Mesh:
    """The last mesh itself, with one warning, of the worst, where triangles are needles.

    `whose`: one hull of several.
    """
    worst = min(meshes, key=lambda mesh: float(quality(mesh.points, mesh.triangles).min()))
    found = quality(worst.points, worst.triangles)
    needles = int((found < _NEEDLE).sum())
    if needles:
        _log.warning(
            "%s: least quality %.2g at x = %.4g m, %d of %d triangles below %g: needles, where "
            "corners of the hull are close or nearly in line; masses and limits hardly suffer, "
            "pressure there may; hull.points= further apart there, or far fewer hull.segments=, "
            "avoid them",
            f"mesh of {whose}" if whose else "mesh",
            found.min(),
            worst.points[worst.triangles[found.argmin()], 0].mean(),
            needles,
            len(found),
            _NEEDLE,
        )
    return meshes[-1]
