"""Whether a mesh has triangles too flat to be trusted."""

import logging

from squat.mesh.mesh import Mesh
from squat.mesh.quality import quality

_log = logging.getLogger(__name__)
_NEEDLE = 0.01
"""Quality at rest that no ready-made hull comes near."""


def told(mesh: Mesh, whose: str = "") -> Mesh:
    """The mesh itself, with a warning where triangles are needles; `whose`: one hull of several."""
    found = quality(mesh.points, mesh.triangles)
    needles = int((found < _NEEDLE).sum())
    if needles:
        _log.warning(
            "%s: least quality %.2g at x = %.4g m, %d of %d triangles below %g: needles, where "
            "corners of the hull are close or nearly in line; numbers hardly suffer, and may be "
            "left; far fewer hull.segments=, or hull.points= further apart there, avoid them",
            f"mesh of {whose}" if whose else "mesh",
            found.min(),
            mesh.points[mesh.triangles[found.argmin()], 0].mean(),
            needles,
            len(found),
            _NEEDLE,
        )
    return mesh
