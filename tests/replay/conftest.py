"""Recordings of short runs, read back."""

import time
from types import SimpleNamespace

import numpy as np
import pytest
from rerun.chunk import RrdReader

from squat import piston, records, transient
from squat.config import compose, validate
from squat.replay.case import ReplayCase
from squat.replay.write import write_replay

COARSE = ("mesh=coarse", "accuracy.near=0.4", "current=2.0", "time.periods=0.15")


@pytest.fixture(scope="session")
def written(tmp_path_factory):
    """Write the dataset of `squat task=<task> <overrides>`, each once."""
    folder, known = tmp_path_factory.mktemp("runs"), {}

    def write(name, task, *overrides):
        path = folder / f"{name}.nc"
        if name not in known:
            valid = validate(compose(task, *overrides))
            started = time.perf_counter()
            if task == "transient":
                data, fields = transient.run(valid.case)
                groups = {} if fields is None else {"fields": fields}
            else:
                data, groups = piston.run(valid.case), {}
            records.save(data, path, valid.config, started, groups)
            known[name] = (task, overrides)
        assert known[name] == (task, overrides)
        return path

    return write


@pytest.fixture(scope="session")
def ship(written):
    """A transient with snapshots at every fourth step."""
    return written("ship", "transient", *COARSE, "snapshots=4")


@pytest.fixture(scope="session")
def bare(written):
    """A transient without snapshots, with other steps."""
    return written("bare", "transient", *COARSE, "time.steps_per_period=50")


@pytest.fixture(scope="session")
def kept(written):
    """A transient whose steps keep the energy, over most of a swing at 2.25 m/s."""
    how = ("force=variational", "model=curves", "coupling=energy_momentum")
    keys = (key for key in COARSE if not key.startswith(("current", "time")))
    return written("kept", "transient", *keys, *how, "current=2.25", "time.periods=2")


@pytest.fixture(scope="session")
def tube(written):
    return written("tube", "piston", "time.periods=0.5")


@pytest.fixture(scope="session")
def record(tmp_path_factory):
    """Write the recording of some datasets; its path."""

    def make(*paths):
        out = tmp_path_factory.mktemp("replay") / "replay.rrd"
        write_replay(ReplayCase(run=tuple(map(str, paths))), out)
        return out

    return make


@pytest.fixture(scope="session")
def entities():
    """What a recording holds: by entity, its time axes [s, rad] and the rows of each component."""

    def read(path):
        found = {}
        for chunk in RrdReader(path).stream():
            batch = chunk.to_record_batch()
            entity = found.setdefault(
                chunk.entity_path.lstrip("/"), SimpleNamespace(time=[], phase=[], rows={})
            )
            for name in batch.schema.names:
                values = batch.column(name)
                if name in ("sim_time", "phase"):
                    seconds = np.asarray(values).astype("timedelta64[ns]").astype(float) / 1e9
                    getattr(entity, {"sim_time": "time"}.get(name, name)).extend(seconds)
                elif ":" in name:
                    entity.rows.setdefault(name.split(":")[-1], []).extend(values.to_pylist())
        return found

    return read


@pytest.fixture(scope="session")
def shown(record, entities, ship):
    """Recording, dataset and snapshots of `ship`."""
    return entities(record(ship)), records.read(ship), records.read_group(ship, "fields")
