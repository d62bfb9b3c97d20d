"""The time that a thread spends in the library, exceptions raised in another thread, and turns."""

import ctypes
import sys
import threading
import time
from collections.abc import Iterator
from contextlib import contextmanager

SHORT_TURN = 1e-4  # seconds that a thread may run while another waits; 5e-3 as a rule


class ThreadTime:
    """The seconds that a thread has spent in the library, and when its current call began."""

    def __init__(self) -> None:
        self.seconds = 0.0
        self.began: float | None = None


spent_by: dict[int, ThreadTime] = {}  # by thread identifier
# The files whose functions wait for machine code.
WAITING_FILES: set[str] = set()


def library_seconds(thread: int) -> float:
    """The seconds that a thread has spent so far in interpreted functions of this library."""
    spent = spent_by.get(thread)
    if spent is None:
        return 0.0
    began = spent.began
    return spent.seconds + (0.0 if began is None else time.perf_counter() - began)


class Withdrawn(BaseException):
    """What takes the place of an exception that is withdrawn."""


def raise_in(thread: int, error: type[BaseException]) -> None:
    """Raise an exception in a thread, soon; it takes the place of one that is still to come."""
    ctypes.pythonapi.PyThreadState_SetAsyncExc(ctypes.c_ulong(thread), ctypes.py_object(error))


def withdraw_exception() -> None:
    """Withdraw an exception that was raised in this thread and is still to come.

    Another takes its place and ends here. Without it Python 3.11 goes on looking for one in all
    threads: every function is slower, and the first that is traced line by line never ends.
    """
    try:
        raise_in(threading.get_ident(), Withdrawn)
        while True:
            pass
    except Withdrawn:
        pass


@contextmanager
def short_turns() -> Iterator[None]:
    """Let threads take shorter turns.

    A thread that reads many files gives up its turn at each. While another thread computes, it
    waits for a whole turn to get it back: an import of numba took ten seconds instead of one.
    """
    usual = sys.getswitchinterval()
    sys.setswitchinterval(SHORT_TURN)
    try:
        yield
    finally:
        sys.setswitchinterval(usual)
