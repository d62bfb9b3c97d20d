"""Futures as they are done. `concurrent.futures.wait` holds their locks now and then, and Ctrl-C at
such a moment leaves one locked for ever; here a queue is waited on that Ctrl-C cannot break.
"""

from collections.abc import Iterator
from concurrent.futures import Future
from contextlib import suppress
from queue import Empty, SimpleQueue
from typing import Any, Generic, TypeVar

T = TypeVar("T")


class Arrivals(Generic[T]):
    """Futures that are waited for, each with what it is for; more may join while those that are
    done are gone through.

    >>> from concurrent.futures import ThreadPoolExecutor
    >>> with ThreadPoolExecutor(1) as executor:
    ...     arrivals = Arrivals()
    ...     for word in ("to", "fro"):
    ...         arrivals.expect(executor.submit(len, word), word)
    ...     sorted((word, future.result()) for word, future in arrivals)
    [('fro', 3), ('to', 2)]
    """

    def __init__(self) -> None:
        self.waiting: dict[Future[Any], T] = {}
        self.done: SimpleQueue[Future[Any]] = SimpleQueue()

    def expect(self, future: "Future[Any]", what: T) -> None:
        """Wait for one more."""
        self.waiting[future] = what
        future.add_done_callback(self.done.put)

    def __iter__(self) -> Iterator[tuple[T, "Future[Any]"]]:
        while self.waiting:
            with suppress(Empty):
                future = self.done.get(
                    timeout=0.2
                )  # woken now and then, so that Ctrl-C is heard on every system
                yield self.waiting.pop(future), future
