"""What `import squat` gives a notebook."""

import doctest
import importlib
import pkgutil
import re
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

import squat as api
from squat.errors import InputError

ROOT = Path(api.__file__).parent
EXAMPLES = [
    module.name
    for module in pkgutil.walk_packages([str(ROOT)], "squat.")
    if ">>> " in Path(module.module_finder.find_spec(module.name).origin).read_text()
]


@pytest.mark.parametrize("name", ["squat", *EXAMPLES])
def test_examples_of_docstrings_run(name, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    result = doctest.testmod(importlib.import_module(name))
    assert result.attempted > 0
    assert result.failed == 0


def test_every_public_name_is_there_and_documented():
    assert set(api.__all__) <= set(dir(api))
    for name in api.__all__:
        assert getattr(api, name).__doc__
        assert f"`{name}`" in api.__doc__
    assert (ROOT / "py.typed").exists()
    with pytest.raises(AttributeError, match="no attribute 'nonsense'"):
        api.nonsense  # noqa: B018


def test_importing_loads_no_library():
    code = "import sys, squat; print([m for m in ('numpy', 'xarray', 'hydra') if m in sys.modules])"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout == "[]\n"


def test_opening_a_run_loads_no_solver(tmp_path):
    api.run("piston", "time.periods=0.1").to_netcdf(tmp_path / "p.nc", engine="h5netcdf")
    code = (
        "import sys, squat; squat.open_run('p.nc')\n"
        "print([m for m in ('hydra', 'gmsh', 'skfem', 'matplotlib') if m in sys.modules])"
    )
    command = [sys.executable, "-c", code]
    done = subprocess.run(command, capture_output=True, text=True, check=True, cwd=tmp_path)
    assert done.stdout == "[]\n"


def test_a_run_in_memory_is_the_run_of_the_command(squat, tmp_path):
    assert squat("task=piston", "time.periods=0.1", "scheme=standard").returncode == 0
    file = api.open_run(tmp_path / "piston.nc")
    memory = api.run("piston", "time.periods=0.1", "scheme=standard")
    assert memory.attrs["content_sha256"] == file.attrs["content_sha256"]
    assert api.config_of(memory) == api.config_of(file)
    assert np.array_equal(memory["position"], file["position"])
    assert all(variable.attrs["units"] for variable in file.variables.values())


def test_what_makes_no_dataset_is_named():
    with pytest.raises(InputError, match="task=figure: makes no dataset; give one of piston"):
        api.run("figure")


@pytest.mark.parametrize("call", [api.run, api.compose])
@pytest.mark.parametrize(
    ("task", "word"),
    [
        ("piston", "pistn.x=2"),
        ("piston", "+piston.mas_ratio=1"),
        ("piston", "piston.mass_ratio=-1"),
        ("piston", "piston.mass_ratio=1,2"),
        ("piston", "piston.length=${no}"),
        ("piston", "accelerator=foo"),
        ("piston", "piston=null"),
        ("piston", "out=["),
        ("foo", "current=1"),
    ],
)
def test_a_notebook_reads_the_line_of_the_command(squat, call, task, word):
    with pytest.raises(InputError) as caught:
        call(task, word)
    assert squat(f"task={task}", word).stderr == f"squat: {caught.value}\n"
    assert caught.value.__suppress_context__  # Hydra's and pydantic's many lines


@pytest.mark.parametrize("word", ["task=mesh", "+task=mesh", 3])
def test_what_is_no_override_is_named(word):
    with pytest.raises(InputError, match=f"^{re.escape(str(word))}: not an override; give"):
        api.compose("piston", word)
