"""A function that may never end, given a bounded time, so that it does not take the notebook with
it.

`within` bounds a whole computation, by the clock on the wall. `within_processor_time` is for a
student's program and is fair to it: it counts what the program itself computes.
"""

import functools
import statistics
import sys
import threading
import time
from collections.abc import Callable, Iterator
from concurrent.futures import Future, wait
from contextvars import copy_context
from types import FrameType
from typing import Any, NamedTuple, Protocol, TypeVar

from .threads import WAITING_FILES, library_seconds, raise_in, spent_by

T = TypeVar("T")


class Bounded(Protocol):
    """A way to give work its time: what work() returns or raises, or TimeUp."""

    def __call__(self, seconds: float, work: Callable[[], T]) -> T: ...


STACK = 64 * 2**20  # bytes: deep recursion fails in Python's words, not in the operating system's
IN_BROWSER = sys.platform == "emscripten"  # where Python has no threads
PATIENCE = 1.0  # seconds in which a function that was told to stop may do so
LOOK = 0.02  # seconds between two looks at the time

WAITING = 4.0  # times the limit: so long a program may do little but wait
LITTLE = 0.1  # of the time on the wall: who computes less than that waits
MOST = 20.0  # times the limit: no program runs for longer, whatever it does

REFERENCE = 0.0015  # seconds that practice() takes a typical computer
SLOWEST = 20.0  # times as slow as that: no computer is taken for a slower one


class Seen(NamedTuple):
    """Lines of one call of a function, from the first to the last: nothing else was seen to run."""

    file: str
    function: str
    first: int
    last: int


class TimeUp(BaseException):
    """The time given is over. Not an Exception, so that `except Exception` does not catch it.

    used, allowed : seconds of computing, as they are counted; the limit as it is on this computer.
    passed : seconds on the wall. left_running : it could not be stopped, and still takes its share
    of the computer until Python ends. seen : where it was in all of the last half of its time.
    """

    def __init__(
        self,
        used: float = 0.0,
        allowed: float = 0.0,
        passed: float = 0.0,
        left_running: bool = False,
        seen: Seen | None = None,
    ) -> None:
        super().__init__()
        self.used, self.allowed, self.passed = used, allowed, passed
        self.left_running, self.seen = left_running, seen


def within(seconds: float, work: Callable[[], T]) -> T:
    """What work() returns or raises; TimeUp where that takes longer than `seconds`.

    The work is done in a thread of its own, which is told to stop when its time is up. Python code
    stops then. Where it does not (it waits in the operating system, runs compiled code, or catches
    everything), it is left behind; the caller goes on. In a browser the work is done on the spot,
    for as long as it takes.

    >>> within(1.0, lambda: 2 + 2)
    4
    """
    return bounded(Clock(seconds), work)


def within_processor_time(seconds: float, work: Callable[[], T]) -> T:
    """The same for a student's program: TimeUp where it computes for longer than `seconds`.

    What counts is the processor time of its thread. What interpreted functions of the library take
    does not count, nor what modules take to load. Where the system tells no thread's processor time
    the time on the wall counts in its place. A computer slower than a typical one gives more:
    `seconds` times speed(). A program that does little but wait ends after WAITING times that, and
    any program after MOST times that. To wait for machine code is not the program's waiting.

    >>> within_processor_time(1.0, lambda: 2 + 2)
    4
    """
    if IN_BROWSER:
        return work()
    return bounded(FairClock(seconds * speed()), work)


def bounded(clock: "Clock", work: Callable[[], T]) -> T:
    """What work() returns or raises; TimeUp when a clock says that it is over."""
    if IN_BROWSER:
        return work()
    answer: Future[T] = Future()

    def run() -> None:
        try:
            clock.begin()
            answer.set_result(context.run(work))
        except BaseException as error:
            answer.set_exception(error)

    context = copy_context()
    thread = started(run)
    try:
        while not wait([answer], timeout=LOOK).done and not clock.is_over():
            pass
    finally:
        in_time = answer.done()
        if not in_time:
            stop(thread)
    if in_time:
        return answer.result()
    is_alive = thread.is_alive()
    raise TimeUp(clock.used, clock.allowed, clock.passed, is_alive, clock.seen())


class Clock:
    """The clock on the wall."""

    def __init__(self, allowed: float) -> None:
        self.allowed = allowed
        self.began = time.monotonic()
        self.used = self.passed = 0.0

    def begin(self) -> None:
        """Begin; called in the thread whose time it is."""

    def is_over(self) -> bool:
        """Whether the time is over."""
        self.used = self.passed = time.monotonic() - self.began
        return self.used > self.allowed

    def seen(self) -> Seen | None:
        """Where the work was all the time, if that is known."""
        return None


class FairClock(Clock):
    """The time that a thread's own program has computed, see within_processor_time."""

    def __init__(self, allowed: float) -> None:
        super().__init__(allowed)
        self.thread: int | None = None
        self.clock: int | None = None
        self.busy = self.wall = self.processor = self.library = 0.0
        self.places = Places()

    def begin(self) -> None:
        """Take the times from which it counts."""
        spent_by.pop(threading.get_ident(), None)  # of a thread that had the same number
        self.clock = clock_of_this_thread()
        self.wall = time.monotonic()
        self.processor = self.processor_time()
        self.thread = threading.get_ident()

    def processor_time(self) -> float:
        """What the thread has computed so far; where that is not told, the time on the wall."""
        if self.clock is None:
            return time.monotonic()
        try:
            return time.clock_gettime(self.clock)
        except OSError:  # the thread has just ended
            return self.processor

    def is_over(self) -> bool:
        """Add what has passed since the last look, and decide."""
        if self.thread is None:
            return time.monotonic() - self.began > MOST * self.allowed
        frame = sys._current_frames().get(self.thread)
        wall, processor = time.monotonic(), self.processor_time()
        library = max(self.library, library_seconds(self.thread))
        computed = processor - self.processor
        if not waits_for_machine_code(frame):
            self.passed += wall - self.wall
            self.busy += computed
            if not loads_a_module(frame):
                self.used += max(0.0, computed - (library - self.library))
        self.wall, self.processor, self.library = wall, processor, library
        if max(self.used, self.passed / MOST) > self.allowed / 2.0:
            self.places.add(frame)
        waits = self.passed > WAITING * self.allowed and self.busy < LITTLE * self.passed
        return self.used > self.allowed or waits or self.passed > MOST * self.allowed

    def seen(self) -> Seen | None:
        """The lines in which it computed all the time."""
        return self.places.seen() if self.used > self.allowed else None


class Places:
    """Where a thread is seen: the innermost call that is the same at all looks, and its lines."""

    ENOUGH = 5  # looks, before anything is said
    FEW = 6  # lines

    def __init__(self) -> None:
        self.looks = 0
        self.calls: list[FrameType] = []  # those that were there at all looks, outermost first
        self.lines: list[set[int]] = []  # of each those that it was seen in

    def add(self, frame: FrameType | None) -> None:
        """See where it is now."""
        now = [*calls_of(frame)][::-1]
        if not self.looks:
            self.calls, self.lines = now, [set() for _ in now]
        same = 0
        while same < min(len(now), len(self.calls)) and now[same] is self.calls[same]:
            line = now[same].f_lineno
            if line is not None:  # between two lines it is in none
                self.lines[same].add(line)
            same += 1
        del self.calls[same:], self.lines[same:]
        self.looks += 1

    def seen(self) -> Seen | None:
        """Where it always was; None where that is not a few lines."""
        if self.looks < self.ENOUGH or not self.calls or not self.lines[-1]:
            return None
        code, first, last = self.calls[-1].f_code, min(self.lines[-1]), max(self.lines[-1])
        is_known = last - first < self.FEW
        return Seen(code.co_filename, code.co_name, first, last) if is_known else None


def calls_of(frame: FrameType | None) -> Iterator[FrameType]:
    """The calls that lead to where a thread is, innermost first."""
    while frame is not None:
        yield frame
        frame = frame.f_back


def waits_for_machine_code(frame: FrameType | None) -> bool:
    """Whether a thread does nothing but wait until machine code is made or loaded."""
    return frame is not None and frame.f_code.co_filename in WAITING_FILES


def loads_a_module(frame: FrameType | None) -> bool:
    """Whether a thread is importing something."""
    return any(call.f_code.co_filename.startswith("<frozen importlib") for call in calls_of(frame))


def clock_of_this_thread() -> int | None:
    """The clock of this thread's processor time, which others may read; None where there is none.

    To be asked in the thread itself: of a thread that has ended one must not ask.
    """
    if not hasattr(time, "pthread_getcpuclockid"):
        return None
    try:
        return time.pthread_getcpuclockid(threading.get_ident())
    except OSError:
        return None


@functools.cache
def speed() -> float:
    """How many times as long as a typical computer this one takes; at least 1. Measured once.

    >>> 1.0 <= speed() <= 20.0
    True
    """
    seconds = statistics.median(practice() for _ in range(5))
    return min(max(1.0, seconds / REFERENCE), SLOWEST)


def practice() -> float:
    """Calculate a little in Python; the seconds of processor time it took."""
    began = time.thread_time()
    total = 0
    for i in range(30_000):
        total += i * i % 7
    return time.thread_time() - began


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
    """Raise TimeUp in a thread until it ends, since its code may catch everything; then leave it.

    Where it strikes inside a callback Python would report it as an exception that nobody could see;
    that report is left out.
    """
    report = sys.unraisablehook

    def report_others(lost: Any) -> None:
        if lost.exc_type is not TimeUp:
            report(lost)

    sys.unraisablehook = report_others
    try:
        last = time.monotonic() + PATIENCE
        while thread.is_alive() and thread.ident is not None and time.monotonic() < last:
            raise_in(thread.ident, TimeUp)
            thread.join(0.01)
    finally:
        sys.unraisablehook = report
