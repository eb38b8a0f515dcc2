"""Records with flipped bits or cut short are refused, or hold what was written; no reader dies."""

import gc
import os
import random
import signal

import pytest

from squat import records
from squat.cli.tasks import compute
from squat.config import compose, validate
from squat.errors import InputError
from squat.records.provenance import seal

TRIALS = 150
SECONDS = 20
REFUSED, SAME, OTHER = 0, 1, 2


@pytest.fixture
def record(tmp_path):
    """A record with a group."""
    config = compose("piston", "time.periods=0.1")
    dataset = compute(validate(config))
    records.save(dataset, tmp_path / "run.nc", config, 0.0, {"fields": dataset[["position"]]})
    return tmp_path / "run.nc"


def attempt(path, expected):
    """How reading `path` in a process of its own ends, crashes and hangs included."""
    gc.freeze()  # a search for garbage would copy every page that the child shares
    child = os.fork()
    if child == 0:
        signal.alarm(SECONDS)
        try:
            found = seal(records.read_whole(path)), seal(records.read_group(path, "fields"))
            os._exit(SAME if found == expected else OTHER)
        except InputError:
            os._exit(REFUSED)
    gc.unfreeze()
    return os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])


@pytest.mark.parametrize("harm", ["flip", "cut", "zero"])
def test_a_damaged_record_is_refused_or_whole(record, harm):
    expected = seal(records.read(record)), seal(records.read_group(record, "fields"))
    whole, chance = record.read_bytes(), random.Random(harm)
    ends = []
    for _ in range(TRIALS // 3):
        damaged = bytearray(whole)
        place = chance.randrange(len(whole))
        if harm == "flip":
            for _ in range(chance.choice([1, 1, 4, 32])):
                damaged[chance.randrange(len(whole))] ^= 1 << chance.randrange(8)
        elif harm == "cut":
            damaged = damaged[:place]
        else:
            damaged[place : place + 512] = bytes(len(damaged[place : place + 512]))
        record.write_bytes(damaged)
        ends.append(attempt(record, expected))
    assert set(ends) <= {REFUSED, SAME}
    assert ends.count(REFUSED) > len(ends) / 4


def test_every_value_and_attribute_of_root_and_groups_is_sealed(record):
    import h5py

    whole = record.read_bytes()
    for group in ("/", "fields"):
        for harm in ("value", "attribute", "units"):
            record.write_bytes(whole)
            with h5py.File(record, "r+") as file:
                if harm == "value":
                    file[group]["position"][1] += 1e-12
                elif harm == "units":
                    file[group]["position"].attrs["units"] = "km"
                else:
                    file[group].attrs["title"] = "another"
            with pytest.raises(InputError, match=r"altered|in 'km'"):
                records.read_whole(record)
