"""Name the shared libraries that gmsh needs and this machine lacks, and how to install them."""

import ctypes.util
import sys

APT_PACKAGE = {
    "GL": "libgl1",
    "GLU": "libglu1-mesa",
    "Xcursor": "libxcursor1",
    "Xft": "libxft2",
    "Xinerama": "libxinerama1",
    "gomp": "libgomp1",
}


def missing_packages() -> list[str]:
    """Debian packages of the libraries that the dynamic loader does not find."""
    return [
        package
        for library, package in APT_PACKAGE.items()
        if ctypes.util.find_library(library) is None
    ]


if __name__ == "__main__" and sys.platform == "linux" and (missing := missing_packages()):
    sys.exit(f"missing system libraries for gmsh: run  apt-get install {' '.join(missing)}")
