"""What a thread spends in the library, and how it is stopped."""

import ctypes
import time


class Spent:
    """The seconds that a thread has spent in the library, and when its present call began."""

    def __init__(self) -> None:
        self.seconds = 0.0
        self.began: float | None = None


spent_by: dict[int, Spent] = {}  # by thread
WAITING_FILES: set[str] = (
    set()
)  # the files of the functions in which a thread waits for machine code


def library_seconds(thread: int) -> float:
    """The seconds that a thread has spent so far in interpreted functions of this library."""
    spent = spent_by.get(thread)
    if spent is None:
        return 0.0
    began = spent.began
    return spent.seconds + (0.0 if began is None else time.perf_counter() - began)


def raise_in(thread: int, error: type[BaseException] | None) -> None:
    """Raise an exception in a thread; None takes back one that has not been raised yet."""
    what = None if error is None else ctypes.py_object(error)
    ctypes.pythonapi.PyThreadState_SetAsyncExc(ctypes.c_ulong(thread), what)
