"""A condition is typed with the quotes of the shell only; Hydra reads what was meant."""

import pytest
from hydra.core.override_parser.overrides_parser import OverridesParser

from squat.cli.arguments import readable


@pytest.mark.parametrize(
    "condition",
    [
        "status == 'diverged'",
        'status=="diverged"',
        "'printed' == coupling or scheme == 'standard'",
        'current > 1 and modes == \'["heave", "pitch"]\'',
        "file.str.contains('a\\b\\\\') # \\",
        r"file == 'C:\"x'",
    ],
)
def test_conditions_reach_hydra_as_they_were_typed(condition):
    (word,) = readable([f"where={condition}"])
    assert OverridesParser.create().parse_override(word).value() == condition


@pytest.mark.parametrize(
    "arguments",
    [
        ["""where="status == 'diverged'\""""],
        ["""where='status == "diverged"'"""],
        ["where="],
        ["out=a == b"],
        ["-m", "where='a','b'"],
        ["-m", "task=mesh", "hull.draft=8,9", "hull.length=30", "hydra.sweep.dir=a"],
        ["-m", "task=mesh", "hull=lewis,curve", "hull.pitch_center=null", "~hull.wall"],
        ["task=mesh", "hull=lewis", "hull.segments=24"],
    ],
)
def test_what_hydra_reads_already_stays(arguments):
    assert readable(arguments) == arguments


@pytest.mark.parametrize(
    ("typed", "value"),
    [
        ("hull.segments=24", 24),
        ("+hull.segments=24", 24),
        ("hull.gravity_center=[1.0,-2.0]", [1.0, -2.0]),
        ("hull.note='a, b'", "a, b"),
        ("hulls.mine.draft=9", 9),
    ],
)
def test_a_key_of_a_swept_choice_is_a_sweep_over_one_value(typed, value):
    """Hydra tries what is no sweep on the default choice, which need not have the key."""
    words = ["-m", "task=mesh", "hull=lewis,curve", "hull@hulls.mine=v,lewis", typed]
    *others, last = readable(words)
    assert others == words[:-1]
    one = OverridesParser.create().parse_override(last)
    assert one.is_sweep_override()
    assert one.is_add() == typed.startswith("+")
    (only,) = one.sweep_iterator()
    assert only == value


def test_names_with_commas_are_those_of_files(tmp_path, monkeypatch):
    """A folder that a sweep named by a hull's points."""
    monkeypatch.chdir(tmp_path)
    names = "points-[[0,0],[0,-4]]/run.nc", "b,c.nc", "d.nc"
    for name in names:
        (tmp_path / name).parent.mkdir(exist_ok=True)
        (tmp_path / name).touch()
    assert readable(["task=replay", f"run={','.join(names)}"])[1] == (
        'run=["points-[[0,0],[0,-4]]/run.nc","b,c.nc","d.nc"]'
    )
    assert readable(["task=replay", f"run={names[0]}"])[1] == f'run=["{names[0]}"]'
    assert readable(["task=replay", "run=no,none"])[1] == 'run=["no","none"]'
