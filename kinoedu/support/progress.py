"""Progress on standard error: an animated line in a terminal, one line per stage elsewhere."""

import logging
import sys
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager


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
def show_progress(what: str) -> Iterator[Callable[[int, int], None]]:
    """Show a progress bar while the block runs.

    Yields the function that updates it, which takes how many things are done and how many there
    are.
    """
    began, first, last = time.monotonic(), -1, -1

    def update(done: int, total: int) -> None:
        nonlocal first, last
        first = done if first < 0 else first
        left = ""
        if first < done < total:
            seconds = (time.monotonic() - began) / (done - first) * (total - done)
            left = f", {format_duration(seconds)} left"
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
