"""All figures of one run in one table at its end."""

import pytest

LINES = pytest.StashKey[list]()


@pytest.fixture
def note(request):
    """Keep a figure for the table: what, its value as text, and what was wanted."""
    lines = request.config.stash.setdefault(LINES, [])
    return lambda what, value, wanted="": lines.append((what, value, wanted))


def pytest_terminal_summary(terminalreporter, config):
    timed = getattr(getattr(config, "_benchmarksession", None), "benchmarks", [])
    ratios = [
        (one.name.removeprefix("test_").replace("_", " "), f"{key} {value}", "")
        for one in timed
        for key, value in one.extra_info.items()
    ]
    lines = [("figure", "measured", "wanted"), *config.stash.get(LINES, []), *ratios]
    widths = [max(len(line[column]) for line in lines) for column in (0, 1)]
    terminalreporter.section("figures of this run")
    for what, value, wanted in lines:
        terminalreporter.write_line(f"{what:{widths[0]}}  {value:{widths[1]}}  {wanted}".rstrip())
