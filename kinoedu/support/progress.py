"""Progress on standard error: an animated line in a terminal, one line per stage elsewhere."""

import logging
import sys
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager

Progress = Callable[[int, int], None]  # told how many things are done, and how many there are


class Notes(logging.Handler):
    """A log handler that keeps the last message, such as that a function is being compiled."""

    last = ""

    def emit(self, record: logging.LogRecord) -> None:
        """Keep the message."""
        self.last = record.getMessage()


@contextmanager
def show_stage(what: str) -> Iterator[Notes]:
    """Show what is being done while the block runs; yields the handler of log messages."""
    if sys.stderr is None:  # closed by the caller
        yield Notes()
        return
    notes, done, logger = Notes(), threading.Event(), logging.getLogger("kinoedu")
    level = logger.level
    logger.setLevel(logging.INFO)
    logger.addHandler(notes)
    line = threading.Thread(
        target=animate_line if sys.stderr.isatty() else print_line,
        args=(what, notes, done),
        daemon=True,
    )
    line.start()
    try:
        yield notes
    finally:
        done.set()
        line.join()
        logger.removeHandler(notes)
        logger.setLevel(level)


def animate_line(what: str, notes: Notes, done: threading.Event) -> None:
    """Update one line of a terminal until the work is done, then clear it."""
    started = time.monotonic()
    while not done.wait(0.1):
        remark = f" ({notes.last})" if notes.last else ""
        rewrite_line(f"{what} ... {time.monotonic() - started:.0f} s{remark}")
    rewrite_line("")


def rewrite_line(text: str) -> None:
    """Replace the current line of the terminal."""
    print(f"\r\033[K{text}", end="", file=sys.stderr, flush=True)


def print_line(what: str, notes: Notes, done: threading.Event) -> None:
    """Print one line, for a file or a pipe."""
    print(f"{what} ...", file=sys.stderr, flush=True)


@contextmanager
def show_progress(what: str) -> Iterator[Progress]:
    """Show a progress bar while the block runs; yields the function that updates it."""
    estimate, last = Estimate(), -1

    def update(done: int, total: int) -> None:
        nonlocal last
        estimate.add(done, time.monotonic())
        left = f", {estimate.describe(total)}" if done < total else ""
        tenths = 10 * done // max(total, 1)
        if sys.stderr is not None and sys.stderr.isatty():
            rewrite_line(f"{what} [{'#' * 2 * tenths:<20}] {done}/{total}{left}")
        elif sys.stderr is not None and tenths > last:
            print(f"{what}: {done}/{total}{left} ...", file=sys.stderr, flush=True)
        last = tenths

    try:
        yield update
    finally:
        if sys.stderr is not None and sys.stderr.isatty():
            rewrite_line("")


class Estimate:
    """The remaining time of many things of a kind, from those that were done.

    The first things take longer, since workers start and modules are loaded. So the time counts
    from the moment at which a few are done, and until then there is no estimate.

    >>> estimate = Estimate()
    >>> for done, seconds in ((0, 0.0), (1, 60.0), (5, 61.0), (9, 63.0)):
    ...     estimate.add(done, seconds)
    >>> estimate.describe(19), Estimate().describe(19)
    ('5 s left', 'estimating')
    """

    FIRST, ENOUGH = 5, 4  # things that are not counted, and those that make an estimate
    SECONDS = 2.0  # workers that started together end together: an estimate needs more time

    def __init__(self) -> None:
        self.before = -1  # how many were done before
        self.began: tuple[int, float] | None = None  # how many were not counted, and until when
        self.last = (0, 0.0)

    def add(self, done: int, seconds: float) -> None:
        """Record that so many are done at a time; the first record may be those done before."""
        self.before = done if self.before < 0 else self.before
        self.last = done, seconds
        if self.began is None and done - self.before >= self.FIRST:
            self.began = self.last

    def describe(self, total: int) -> str:
        """The remaining time in words."""
        first, began = self.began or self.last
        done, seconds = self.last[0] - first, self.last[1] - began
        if done < self.ENOUGH or seconds < self.SECONDS:
            return "estimating"
        return f"{format_duration(seconds / done * (total - self.last[0]))} left"


def format_duration(seconds: float) -> str:
    """A duration in a readable unit.

    Examples
    --------
    >>> format_duration(7.6), format_duration(125), format_duration(7300)
    ('8 s', '2 min', '2.0 h')
    """
    if seconds < 100:
        return f"{seconds:.0f} s"
    return f"{seconds / 60:.0f} min" if seconds < 6000 else f"{seconds / 3600:.1f} h"
