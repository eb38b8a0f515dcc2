"""What takes long and comes out the same, made once in a session of tests, whichever process asks.

That is Hydra's reading of `conf/`, and gmsh's triangles. A process without the folder in its
environment makes all anew, and so does a test that deletes it there.
"""

import atexit
import hashlib
import os
import pickle
from pathlib import Path
from tempfile import NamedTemporaryFile, TemporaryDirectory

from squat.mesh import generate as mesh
from tests import composition

FOLDER = "SQUAT_KEPT"
_TRIANGULATED = mesh.triangulated


def begin():
    """Keep in this process; the first one, of which the others are children, has the folder."""
    if FOLDER not in os.environ:
        folder = TemporaryDirectory(prefix="squat-kept-")
        atexit.register(folder.cleanup)
        os.environ[FOLDER] = folder.name
    composition.keep(kept)
    mesh.triangulated = _triangulated


def kept(key, make):
    """`make()` of the first process that asked for `key`, anew for each caller."""
    folder = os.environ.get(FOLDER)
    if folder is None:
        return make()
    path = Path(folder, hashlib.sha256(pickle.dumps(key)).hexdigest())
    if path.exists():
        return pickle.loads(path.read_bytes())
    made = make()
    with NamedTemporaryFile(dir=folder, delete=False) as file:
        pickle.dump(made, file)
    Path(file.name).replace(path)
    return made


def _triangulated(submesh, size):
    return kept(("triangles", submesh, size), lambda: _TRIANGULATED(submesh, size))
