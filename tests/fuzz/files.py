"""Files for bad input: whole ones of squat's own, and what may have become of them."""

import random
from pathlib import Path

import numpy as np
import xarray as xr

from squat import records
from squat.cli.tasks import compute
from squat.config import compose, validate

EVIL = {
    "user/callback.yaml": """# @package _global_
hydra: {callbacks: {evil: {_target_: pathlib.Path.touch, self: evil.flag}}}
""",
    "user/value.yaml": "hull: {_target_: os.system, command: touch evil.flag}\n",
    "user/python.yaml": "x: !!python/object/apply:os.system [touch evil.flag]\n",
    "user/logging.yaml": """# @package _global_
hydra:
  job_logging:
    version: 1
    formatters: {x: {(): os.system, command: touch evil.flag}}
""",
    "primary.yaml": """defaults: [_self_]
hydra: {callbacks: {evil: {_target_: os.system, command: touch evil.flag}}}
""",
}


def _save(folder, name, task, *overrides, **attributes):
    config = compose(task, *overrides)
    dataset = compute(validate(config)).assign_attrs(attributes)
    records.save(dataset, folder / name, config, 0.0)
    return folder / name


def prepare(folder):
    """Fill `folder`; the names of all files in it."""
    good = _save(folder, "good.nc", "piston", "time.periods=0.1")
    _save(folder, "other.nc", "piston", "time.periods=0.1", "piston.mass_ratio=2")
    _save(folder, "roots.nc", "equilibria", "speeds.points=9", "added_mass_ratio=1")
    (folder / "sweep/sub.d").mkdir(parents=True)
    (folder / "sweep/good.nc").write_bytes(good.read_bytes())
    whole = good.read_bytes()
    (folder / "truncated.nc").write_bytes(whole[: len(whole) // 2])
    flipped = bytearray(whole)
    for place in random.Random(1).sample(range(len(whole)), 40):
        flipped[place] ^= 0x10
    (folder / "flipped.nc").write_bytes(flipped)
    foreign = xr.Dataset({"a": ("x", np.arange(3.0))})
    foreign.to_netcdf(folder / "foreign.nc", engine="h5netcdf")
    _save(folder, "future.nc", "piston", "time.periods=0.1", schema="squat/piston/99")
    (folder / "empty.nc").touch()
    (folder / "text.nc").write_text("no dataset")
    with xr.open_dataset(good, engine="h5netcdf") as file:
        altered = file.load()
    altered.attrs["config"] = altered.attrs["config"].replace("1.0", "1.5")
    altered.to_netcdf(folder / "altered.nc", engine="h5netcdf")
    foreign.to_netcdf(folder / "group.nc", engine="h5netcdf", group="fields")
    (folder / "secret.nc").mkdir()
    (folder / "link.nc").symlink_to("nowhere")
    for name, text in EVIL.items():
        path = folder / "evil" / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
    return {str(p) for p in Path(folder).rglob("*") if not p.is_dir()}
