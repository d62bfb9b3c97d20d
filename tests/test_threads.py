"""Exceptions that are raised in a thread and withdrawn, and the turns that threads take."""

import subprocess
import sys
import threading

import pytest

from kinoedu.compiled.numba_thread import NUMBA_THREAD
from kinoedu.support.threads import SHORT_TURN, raise_in, short_turns, withdraw_exception

AFTER_A_WITHDRAWAL = """
import sys, threading
from kinoedu.support.threads import raise_in, withdraw_exception
from kinoedu.support.time_limit import stop_thread

thread = threading.Thread(target=lambda: None)
thread.start()
stop_thread(thread)
withdraw_exception()
lines = []
def tracer(frame, event, value):
    lines.append(event)
    return tracer
def double(x):
    return 2 * x
sys.settrace(tracer)
double(3)
sys.settrace(None)
print(lines)
"""


class Stop(BaseException):
    """What is raised in a thread."""


def wait_for(error: type[BaseException]) -> None:
    """Raise an exception in this thread, and wait until it comes."""
    raise_in(threading.get_ident(), error)
    while True:
        pass


def test_an_exception_is_raised_in_a_thread_after_another_was_withdrawn():
    """What takes the place of the one that is withdrawn never leaves the function."""
    for _ in range(100):
        withdraw_exception()
    with pytest.raises(Stop):
        wait_for(Stop)
    withdraw_exception()


def test_lines_are_traced_after_a_withdrawal():
    """Python 3.11 goes round for ever where it was told that an exception comes, and none does."""
    done = subprocess.run(
        [sys.executable, "-c", AFTER_A_WITHDRAWAL], capture_output=True, text=True, timeout=60
    )
    assert done.stdout.strip() == "['call', 'line', 'return']", done.stderr


def test_turns_are_short_for_a_while():
    """Also if what is done meanwhile fails."""
    usual, turns = sys.getswitchinterval(), []

    @short_turns()
    def fail() -> None:
        turns.append(sys.getswitchinterval())
        raise Stop

    with pytest.raises(Stop):
        fail()
    assert [*turns, sys.getswitchinterval()] == [pytest.approx(SHORT_TURN), usual]


def test_a_thread_that_computes_does_not_keep_machine_code_waiting():
    """What imports numba and reads files gets its turn back soon."""
    turns: list[float] = []
    NUMBA_THREAD.run_and_wait(lambda: turns.append(sys.getswitchinterval()))
    assert turns == [pytest.approx(SHORT_TURN)]
