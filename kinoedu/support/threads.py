"""The time that a thread spends in the library, and exceptions raised in another thread."""

import ctypes
import time


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


def raise_in(thread: int, error: type[BaseException] | None) -> None:
    """Raise an exception in a thread; None cancels one that has not been raised yet."""
    what = None if error is None else ctypes.py_object(error)
    ctypes.pythonapi.PyThreadState_SetAsyncExc(ctypes.c_ulong(thread), what)
