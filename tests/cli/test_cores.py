"""Work over the cores: answers in order, errors passed on, no process left behind."""

import signal
import subprocess
import sys
import time

import psutil
import pytest

from squat.cores import spread

WAIT = "import time; from squat.cores import spread; spread(time.sleep, [(600,)] * 4, 'sleep')"


@pytest.fixture(autouse=True)
def two_cores(monkeypatch):
    monkeypatch.setenv("LOKY_MAX_CPU_COUNT", "2")


def test_answers_come_in_the_order_of_the_arguments_whatever_starts_first():
    numbers = [(3, 2), (2, 2), (5, 1), (1, 0)]
    assert spread(pow, numbers, "powers") == [9, 4, 5, 1]
    assert spread(pow, numbers, "powers", cost=lambda base, _: base) == [9, 4, 5, 1]
    assert spread(pow, [], "powers") == []


def test_an_error_reaches_the_caller_as_it_was_raised():
    with pytest.raises(ZeroDivisionError):
        spread(divmod, [(1, 1), (1, 0)], "divisions")


def test_workers_end_with_a_killed_process():
    victim = subprocess.Popen([sys.executable, "-c", WAIT])
    try:
        while len(children := psutil.Process(victim.pid).children(recursive=True)) < 2:
            time.sleep(0.05)
            assert victim.poll() is None
    finally:
        victim.send_signal(signal.SIGKILL)
        victim.wait()
    _, alive = psutil.wait_procs(children, timeout=60)
    assert alive == []
