"""Futures in the order in which they complete.

`concurrent.futures.wait` holds the futures' locks at times, and Ctrl-C at such a moment leaves a
lock held for ever. This module waits on a queue, which Ctrl-C cannot damage.
"""

from collections.abc import Iterator
from concurrent.futures import CancelledError, Future
from contextlib import suppress
from queue import Empty, SimpleQueue
from typing import Any, Generic, TypeVar

T = TypeVar("T")


class CompletedFutures(Generic[T]):
    """An iterable of pairs (label, future) in the order in which the futures complete.

    More futures may be added while the iteration runs.

    Examples
    --------
    >>> from concurrent.futures import ThreadPoolExecutor
    >>> with ThreadPoolExecutor(1) as executor:
    ...     completed = CompletedFutures()
    ...     for word in ("to", "fro"):
    ...         completed.add(executor.submit(len, word), word)
    ...     sorted((word, future.result()) for word, future in completed)
    [('fro', 3), ('to', 2)]
    """

    def __init__(self) -> None:
        self.waiting: dict[Future[Any], T] = {}
        self.done: SimpleQueue[Future[Any]] = SimpleQueue()

    def add(self, future: "Future[Any]", what: T) -> None:
        """Add a future with its label."""
        self.waiting[future] = what
        future.add_done_callback(self.done.put)

    def __iter__(self) -> Iterator[tuple[T, "Future[Any]"]]:
        while self.waiting:
            with suppress(Empty):
                future = self.done.get(timeout=0.2)  # some systems check for Ctrl-C on waking only
                yield self.waiting.pop(future), future


def failure_of(future: "Future[Any]") -> BaseException | None:
    """The error with which a completed future ended, or None.

    Raises
    ------
    ConnectionError
        Where the future was cancelled: Dask's client does this when its scheduler is gone.
    """
    try:
        return future.exception()
    except CancelledError:
        raise ConnectionError(
            "the workers were lost, as when a Dask scheduler ends; what was finished is kept, and "
            "the same command or call with the same folder continues"
        ) from None
