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
    ],
)
def test_what_hydra_reads_already_stays(arguments):
    assert readable(arguments) == arguments
