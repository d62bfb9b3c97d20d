"""A function that may never end, given a bounded time: a student's endless loop must not take the notebook with it."""

import ctypes
import sys
import threading
import time
from collections.abc import Callable
from concurrent.futures import Future, wait
from contextvars import copy_context
from typing import Any, Protocol, TypeVar

T = TypeVar("T")


class Bounded(Protocol):
    """A way to give work its time: what work() returns or raises, or TimeUp."""

    def __call__(self, seconds: float, work: Callable[[], T]) -> T: ...


STACK = 64 * 2**20  # bytes: deep recursion fails in Python's words, not in the operating system's
IN_BROWSER = sys.platform == "emscripten"  # where Python has no threads
PATIENCE = 1.0  # seconds in which a function that was told to stop may do so


class TimeUp(BaseException):
    """The time given is over. Not an Exception, so that a student's own `except Exception` does not catch it.

    left_running : it could not be stopped, and still takes its share of the computer until Python ends.
    """

    left_running = False


def within(seconds: float, work: Callable[[], T]) -> T:
    """What work() returns or raises; TimeUp where that takes longer than `seconds`.

    The work is done in a thread of its own, which is told to stop when its time is up. Python code stops then. Where it does
    not (it waits in the operating system, runs compiled code, or catches everything), it is left behind; the caller goes on.
    In a browser the work is done on the spot, for as long as it takes.

    >>> within(1.0, lambda: 2 + 2)
    4
    """
    if IN_BROWSER:
        return work()
    answer: Future[T] = Future()

    def run() -> None:
        try:
            answer.set_result(context.run(work))
        except BaseException as error:
            answer.set_exception(error)

    context = copy_context()
    thread = started(run)
    try:
        wait([answer], timeout=seconds)
    finally:
        in_time = answer.done()
        if not in_time:
            stop(thread)
    if in_time:
        return answer.result()
    over = TimeUp()
    over.left_running = thread.is_alive()
    raise over


def started(run: Callable[[], None]) -> threading.Thread:
    """A thread that does it, with room for deep recursion."""
    before = threading.stack_size(STACK)
    try:
        thread = threading.Thread(target=run, daemon=True)
        thread.start()
    finally:
        threading.stack_size(before)
    return thread


def stop(thread: threading.Thread) -> None:
    """Raise TimeUp in a thread until it ends, since its code may catch everything; in the end leave it.

    Where it strikes inside a callback Python would report it as an exception that nobody could see; that report is left out.
    """
    report = sys.unraisablehook

    def report_others(lost: Any) -> None:
        if lost.exc_type is not TimeUp:
            report(lost)

    sys.unraisablehook = report_others
    try:
        last = time.monotonic() + PATIENCE
        while thread.is_alive() and thread.ident is not None and time.monotonic() < last:
            ctypes.pythonapi.PyThreadState_SetAsyncExc(ctypes.c_ulong(thread.ident), ctypes.py_object(TimeUp))
            thread.join(0.01)
    finally:
        sys.unraisablehook = report
