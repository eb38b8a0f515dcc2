"""Progress: the time left follows from work alone, skipped jobs are named with their ends."""

import logging
import time
from pathlib import Path

import pytest
from tqdm import tqdm

from squat import progress as module
from squat.cli.jobs import _LOOK, Board
from squat.progress import progress

SKIPPED, WORKED = 8, 2


@pytest.fixture
def clock(monkeypatch):
    """A clock in place of the machine's; `items` takes ten seconds a worked one."""
    now = [0.0]
    monkeypatch.setattr(module.time, "monotonic", lambda: now[0])

    def items():
        for number in range(SKIPPED + WORKED):
            now[0] += 10.0 * (number >= SKIPPED)
            yield number

    return items, now


def show(items):
    shown = progress(items, 20, "jobs", worked=lambda n: n >= SKIPPED)
    assert list(shown) == list(range(SKIPPED + WORKED))


def test_lines_tell_the_time_left_by_the_work_alone(clock, caplog):
    items, _ = clock
    with caplog.at_level(logging.INFO):
        show(items())
    lines = [record.getMessage() for record in caplog.records]
    assert lines[: SKIPPED // 2] == [f"jobs: {n} of 20" for n in (2, 4, 6, 8)]
    assert lines[-1] == "jobs: 10 of 20, 0:01:40 left"


def test_the_bar_rates_the_work_alone(clock, monkeypatch, caplog):
    items, _ = clock
    meters = []

    class Bar(tqdm):
        def close(self):
            meters.append(tqdm.format_meter(**{**self.format_dict, "elapsed": 20.0}))
            super().close()

    monkeypatch.setattr(module, "tqdm", Bar)
    monkeypatch.setattr(module.sys.stderr, "isatty", lambda: True, raising=False)
    with caplog.at_level(logging.INFO):
        show(items())
    assert "10/20 [00:20<01:40" in meters[0]


def test_the_board_counts_skipped_jobs_by_how_they_ended(tmp_path, caplog):
    names = [str(number) for number in range(6)]
    ends = ["skipped.diverged", "skipped.iteration limit", "skipped.diverged", "done.", "failed."]
    with caplog.at_level(logging.INFO):
        board = Board(tmp_path, names)
        for number, end in enumerate([*ends, "skipped.completed"]):
            (Path(board.folder.name) / f"{number}.{end}").touch()
        assert board.close()
    assert caplog.records[-1].getMessage() == (
        "jobs: 6 of 6, 4 skipped (1 completed, 2 diverged, 1 iteration limit), 1 failed"
    )


def test_a_board_clears_what_killed_sweeps_left_and_no_other(tmp_path):
    (tmp_path / ".jobs-killed").mkdir()
    first = Board(tmp_path, ["0"])
    second = Board(tmp_path, ["0"])
    assert sorted(tmp_path.iterdir()) == sorted(map(Path, (first.folder.name, second.folder.name)))
    assert not first.close()
    assert not second.close()
    assert list(tmp_path.iterdir()) == []


def test_a_board_without_its_folder_closes_in_peace(tmp_path):
    board = Board(tmp_path, ["0"])
    Path(board.folder.name).rmdir()
    time.sleep(2 * _LOOK)
    assert board._thread.is_alive()
    assert not board.close()
