"""Time limits for functions that may never end, so that they do not block a notebook.

`run_within` limits a whole computation by wall-clock time, `run_within_thread_time` by the
processor time that it uses. `run_within_processor_time` is for a student's program and counts only
what that program itself computes.
"""

import functools
import gc
import statistics
import sys
import threading
import time
from collections.abc import Callable
from concurrent.futures import Future, wait
from contextlib import suppress
from contextvars import copy_context
from itertools import accumulate, chain, repeat, starmap, takewhile, tee
from operator import attrgetter, methodcaller
from types import CodeType, FrameType
from typing import Any, NamedTuple, Protocol, TypeVar

from .threads import WAITING_FILES, library_seconds, raise_in, spent_by, withdraw_exception

T = TypeVar("T")


class Limiter(Protocol):
    """A function that runs work() with a time limit, such as `run_within`."""

    def __call__(self, seconds: float, work: Callable[[], T]) -> T: ...


# Bytes. With a large stack, deep recursion ends with Python's RecursionError, not in a crash.
STACK_SIZE = 64 * 2**20
IN_BROWSER = sys.platform == "emscripten"  # Python has no threads there
GRACE = 1.0  # seconds that a function has to stop
POLL_INTERVAL = 0.02  # seconds

MAX_WAIT_FACTOR = 4.0  # a program that only waits ends after this many times the limit
BUSY_SHARE = 0.1  # a program that computes for less of the wall-clock time only waits
LONGEST = 20.0  # every program ends after this many times the limit of wall-clock time

REFERENCE = 0.0015  # seconds that time_practice_loop() takes on a typical computer
SLOWEST = 20.0  # no computer counts as more times slower than that


Call = tuple[FrameType, tuple[CodeType, int | None]]  # its frame, its code and the line in it


class SeenLines(NamedTuple):
    """The lines of one call of a function, first to last, in which a thread was seen."""

    file: str
    function: str
    first: int
    last: int


class TimeUp(BaseException):
    """The time limit is exceeded.

    It is not an Exception, so that `except Exception` does not catch it.

    used, allowed : seconds of computation as they are counted; the limit on this computer.
    passed : seconds of wall-clock time.
    left_running : whether the work could not be stopped, and uses the computer until Python ends.
    seen : where the work was during the last half of its time.
    """

    def __init__(
        self,
        used: float = 0.0,
        allowed: float = 0.0,
        passed: float = 0.0,
        left_running: bool = False,
        seen: SeenLines | None = None,
    ) -> None:
        super().__init__()
        self.used, self.allowed, self.passed = used, allowed, passed
        self.left_running, self.seen = left_running, seen


def run_within(seconds: float, work: Callable[[], T]) -> T:
    """Run work() with a limit of wall-clock time, and return its result.

    The work runs in a separate thread, which is told to stop at the limit. Python code then stops.
    Work that does not stop (it waits in the operating system, runs compiled code, or catches
    everything) is abandoned, and the caller continues. In a browser, the work runs in place and
    without a limit.

    Raises
    ------
    TimeUp
        Where the work takes longer than `seconds`. Errors of the work are raised unchanged.

    Examples
    --------
    >>> run_within(1.0, lambda: 2 + 2)
    4
    """
    return run_bounded(Clock(seconds), work)


def run_within_processor_time(seconds: float, work: Callable[[], T]) -> T:
    """Run a student's program with a limit of processor time, and return its result.

    Only the processor time of its thread counts. The time spent in interpreted functions of the
    library and in imports does not count. Systems that cannot tell a thread's processor time use
    wall-clock time. A slower computer gets proportionally more: `seconds` times slowdown(). A
    program that only waits ends after MAX_WAIT_FACTOR times the limit, and every program after
    LONGEST times the limit. Waiting for machine code does not count as waiting.

    Raises
    ------
    TimeUp
        Where the program computes for longer than `seconds`. Its own errors are raised unchanged.

    Examples
    --------
    >>> run_within_processor_time(1.0, lambda: 2 + 2)
    4
    """
    if IN_BROWSER:
        return work()
    return run_bounded(FairClock(seconds * slowdown()), work)


def run_within_thread_time(seconds: float, work: Callable[[], T]) -> T:
    """Run work() with a limit of processor time, whichever functions it calls.

    On a busy computer it takes longer, up to LONGEST times the limit on the wall clock. Otherwise
    it is like `run_within`.

    Raises
    ------
    TimeUp
        Where the work computes for longer than `seconds`. Errors of the work are raised unchanged.

    Examples
    --------
    >>> run_within_thread_time(1.0, lambda: 2 + 2)
    4
    """
    return run_bounded(ThreadClock(seconds), work)


def run_bounded(clock: "Clock", work: Callable[[], T]) -> T:
    """Run work() until it ends or a clock says that its time is over (TimeUp)."""
    if IN_BROWSER:
        return work()
    answer: Future[T] = Future()

    def run() -> None:
        with suppress(TimeUp):  # another one, while the first is recorded
            try:
                clock.begin()
                answer.set_result(context.run(work))
            except BaseException as error:
                answer.set_exception(error)

    context = copy_context()
    thread = start_thread(run)
    try:
        while not wait([answer], timeout=POLL_INTERVAL).done and not clock.is_over():
            pass
    finally:
        in_time = answer.done()
        if not in_time:
            stop_thread(thread)
    if in_time:
        return answer.result()
    is_alive = thread.is_alive()
    raise TimeUp(clock.used, clock.allowed, clock.passed, is_alive, clock.seen())


class Clock:
    """A clock of wall-clock time."""

    def __init__(self, allowed: float) -> None:
        self.allowed = allowed
        self.began = time.monotonic()
        self.used = self.passed = 0.0

    def begin(self) -> None:
        """Start the clock; called in the thread whose time it measures."""

    def is_over(self) -> bool:
        """Whether the time is over."""
        self.used = self.passed = time.monotonic() - self.began
        return self.used > self.allowed

    def seen(self) -> SeenLines | None:
        """Where the work spent its time, if known."""
        return None


class FairClock(Clock):
    """A clock of the time that a thread's own program computes, as in run_within_processor_time."""

    def __init__(self, allowed: float) -> None:
        super().__init__(allowed)
        self.thread: int | None = None
        self.clock: int | None = None
        self.busy = self.wall = self.processor = self.library = 0.0
        self.seen_calls = SeenCalls()

    def begin(self) -> None:
        """Record the times at which it starts."""
        spent_by.pop(threading.get_ident(), None)  # of an ended thread with the same identifier
        self.clock = clock_of_this_thread()
        self.wall = time.monotonic()
        self.processor = self.processor_time()
        self.thread = threading.get_ident()

    def processor_time(self) -> float:
        """The thread's processor time so far, or the wall-clock time where it is unknown."""
        if self.clock is None:
            return time.monotonic()
        try:
            return time.clock_gettime(self.clock)
        except OSError:  # the thread has just ended
            return self.processor

    def is_over(self) -> bool:
        """Add the time since the last look, and decide."""
        if self.thread is None:
            return time.monotonic() - self.began > LONGEST * self.allowed
        calls = calls_of(self.thread)
        wall, processor = time.monotonic(), self.processor_time()
        library = max(self.library, library_seconds(self.thread))
        computed = processor - self.processor
        if not waits_for_machine_code(calls):
            self.passed += wall - self.wall
            self.busy += computed
            if not loads_a_module(calls):
                self.used += max(0.0, computed - (library - self.library))
        self.wall, self.processor, self.library = wall, processor, library
        if max(self.used, self.passed / LONGEST) > self.allowed / 2.0:
            self.seen_calls.add(calls)
        waits = (
            self.passed > MAX_WAIT_FACTOR * self.allowed and self.busy < BUSY_SHARE * self.passed
        )
        return self.used > self.allowed or waits or self.passed > LONGEST * self.allowed

    def seen(self) -> SeenLines | None:
        """The lines in which the program spent its time, if it used up its processor time."""
        return self.seen_calls.seen() if self.used > self.allowed else None


class ThreadClock(FairClock):
    """A clock of all processor time that a thread uses."""

    def is_over(self) -> bool:
        """Whether the processor time is over, or far more time has passed."""
        if self.thread is None:
            return super().is_over()
        self.used = self.processor_time() - self.processor
        self.passed = time.monotonic() - self.wall
        return self.used > self.allowed or self.passed > LONGEST * self.allowed


class SeenCalls:
    """The innermost call that was running at every look at a thread, and its lines."""

    MIN_LOOKS = 5
    MAX_LINES = 6

    def __init__(self) -> None:
        self.looks = 0
        self.calls: list[Call] = []  # running at every look, outermost first
        self.lines: list[set[int]] = []  # the lines of each call in which it was seen

    def add(self, calls: list[Call]) -> None:
        """Record where the thread is now."""
        now = calls[::-1]
        if not self.looks:
            self.calls, self.lines = now, [set() for _ in now]
        same = 0
        while same < min(len(now), len(self.calls)) and now[same][0] is self.calls[same][0]:
            _, (_, line) = now[same]
            if line is not None:  # None between two lines
                self.lines[same].add(line)
            same += 1
        del self.calls[same:], self.lines[same:]
        self.looks += 1

    def seen(self) -> SeenLines | None:
        """Where the thread was at every look; None where that is not a few lines."""
        if self.looks < self.MIN_LOOKS or not self.calls or not self.lines[-1]:
            return None
        _, (code, _) = self.calls[-1]
        first, last = min(self.lines[-1]), max(self.lines[-1])
        is_known = last - first < self.MAX_LINES
        return SeenLines(code.co_filename, code.co_name, first, last) if is_known else None


def calls_of(thread: int) -> list[Call]:
    """The calls on a thread's stack at one moment, innermost first; none where it has ended.

    Only C functions follow the stack and read it, without a collection of cycles between them, so
    the thread does not run meanwhile. Processes crashed where Python functions followed a stack
    that could change, and where a frame was asked later: only its identity is of use.
    """
    was_enabled = gc.isenabled()
    try:
        gc.disable()
        innermost = map(methodcaller("get", thread), starmap(sys._current_frames, [()]))
        frames = takewhile(bool, accumulate(chain(innermost, repeat("f_back")), getattr))
        kept, asked = tee(frames)
        return list(zip(kept, map(attrgetter("f_code", "f_lineno"), asked)))
    finally:
        if was_enabled:
            gc.enable()


def waits_for_machine_code(calls: list[Call]) -> bool:
    """Whether a thread only waits until machine code is made or loaded."""
    return calls != [] and file_of(calls[0]) in WAITING_FILES


def loads_a_module(calls: list[Call]) -> bool:
    """Whether a thread is importing a module."""
    return any(file_of(call).startswith("<frozen importlib") for call in calls)


def file_of(call: Call) -> str:
    """The file of a call's function."""
    _, (code, _) = call
    return code.co_filename


def clock_of_this_thread() -> int | None:
    """The clock of this thread's processor time, or None.

    Other threads may read the clock. It must be obtained in the thread itself, because the call is
    unsafe for a thread that has ended.
    """
    if not hasattr(time, "pthread_getcpuclockid"):
        return None
    try:
        return time.pthread_getcpuclockid(threading.get_ident())
    except OSError:
        return None


@functools.cache
def slowdown() -> float:
    """How many times slower this computer is than a typical one; at least 1. Measured once.

    Examples
    --------
    >>> 1.0 <= slowdown() <= 20.0
    True
    """
    seconds = statistics.median(time_practice_loop() for _ in range(5))
    return min(max(1.0, seconds / REFERENCE), SLOWEST)


def time_practice_loop() -> float:
    """The seconds of processor time that a short loop in Python takes."""
    began = time.thread_time()
    total = 0
    for i in range(30_000):
        total += i * i % 7
    return time.thread_time() - began


def start_thread(run: Callable[[], None]) -> threading.Thread:
    """Start a daemon thread with a stack for deep recursion."""
    before = threading.stack_size(STACK_SIZE)
    try:
        thread = threading.Thread(target=run, daemon=True)
        thread.start()
    finally:
        threading.stack_size(before)
    return thread


def stop_thread(thread: threading.Thread) -> None:
    """Raise TimeUp in a thread until it ends, or GRACE is over.

    Its code may catch everything, so it is raised repeatedly. Python would report a TimeUp raised
    inside a callback as an unraisable exception; that report is suppressed.
    """
    report = sys.unraisablehook

    def report_others(lost: Any) -> None:
        if lost.exc_type is not TimeUp:
            report(lost)

    sys.unraisablehook = report_others
    try:
        last = time.monotonic() + GRACE
        while thread.is_alive() and thread.ident is not None and time.monotonic() < last:
            raise_in(thread.ident, TimeUp)
            thread.join(0.01)
    finally:
        sys.unraisablehook = report
        withdraw_exception()  # where the thread ended before the last one came
