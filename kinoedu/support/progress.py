"""What is being done and for how long, on standard error: a line that moves in a terminal, a line
for each stage elsewhere.
"""

import logging
import sys
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager


class Notes(logging.Handler):
    """The last remark logged while a stage runs, such as that something is compiled once."""

    last = ""

    def emit(self, record: logging.LogRecord) -> None:
        """Keep it."""
        self.last = record.getMessage()


@contextmanager
def stage(what: str) -> Iterator[Notes]:
    """Say what is being done while it is; yields what was remarked meanwhile."""
    if sys.stderr is None:  # closed by the caller
        yield Notes()
        return
    notes, done, logger = Notes(), threading.Event(), logging.getLogger("kinoedu")
    level = logger.level
    logger.setLevel(logging.INFO)
    logger.addHandler(notes)
    line = threading.Thread(
        target=move if sys.stderr.isatty() else stand, args=(what, notes, done), daemon=True
    )
    line.start()
    try:
        yield notes
    finally:
        done.set()
        line.join()
        logger.removeHandler(notes)
        logger.setLevel(level)


def move(what: str, notes: Notes, done: threading.Event) -> None:
    """Keep one line of a terminal up to date, and clear it in the end."""
    started = time.monotonic()
    while not done.wait(0.1):
        remark = f" ({notes.last})" if notes.last else ""
        print(
            f"\r\033[K{what} ... {time.monotonic() - started:.0f} s{remark}",
            end="",
            file=sys.stderr,
            flush=True,
        )
    print("\r\033[K", end="", file=sys.stderr, flush=True)


def stand(what: str, notes: Notes, done: threading.Event) -> None:
    """Say it once, for a file or a pipe."""
    print(f"{what} ...", file=sys.stderr, flush=True)


@contextmanager
def counted(what: str) -> Iterator[Callable[[int, int], None]]:
    """A bar that fills as things are done; yields what is told how many are done, and of how
    many.
    """
    began, first, last = time.monotonic(), -1, -1

    def tell(done: int, everything: int) -> None:
        nonlocal first, last
        first = done if first < 0 else first
        gone = time.monotonic() - began
        left = (
            f", {duration(gone / (done - first) * (everything - done))} left"
            if first < done < everything
            else ""
        )
        tenths = 10 * done // max(everything, 1)
        if sys.stderr is not None and sys.stderr.isatty():
            print(
                f"\r\033[K{what} [{'#' * 2 * tenths:<20}] {done}/{everything}{left}",
                end="",
                file=sys.stderr,
                flush=True,
            )
        elif sys.stderr is not None and tenths > last:
            print(f"{what}: {done}/{everything}{left} ...", file=sys.stderr, flush=True)
        last = tenths

    try:
        yield tell
    finally:
        if sys.stderr is not None and sys.stderr.isatty():
            print("\r\033[K", end="", file=sys.stderr, flush=True)


def duration(seconds: float) -> str:
    """A time as one reads it.

    >>> duration(7.6), duration(125), duration(7300)
    ('8 s', '2 min', '2.0 h')
    """
    return (
        f"{seconds:.0f} s"
        if seconds < 100
        else f"{seconds / 60:.0f} min"
        if seconds < 6000
        else f"{seconds / 3600:.1f} h"
    )
