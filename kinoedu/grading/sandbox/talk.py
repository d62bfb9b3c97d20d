"""Exchange lines with a process that cannot be trusted, in bounded time.

The process may write anything, write nothing, never read, or never end.
"""

import os
import selectors
import time
from collections import deque
from collections.abc import Iterator

MOST_OUTPUT = 32 * 2**20  # bytes
MOST_PARTS = 2**21  # commas and brackets; each may be a value, which takes far more than a byte
MOST_LINE = 2**20
LONGEST = 150.0  # seconds for the whole exchange
USUAL = 160.0  # patience on a usual computer, in seconds
START = 60.0  # seconds until the first line, on a slow computer


class Talk:
    """Lines to and from a process, through two pipes.

    `end` is how it ended: "late", "flood", or "died" where the process closed its pipe.
    """

    def __init__(self, requests: int, replies: int, patience: float) -> None:
        self.requests, self.replies, self.patience = requests, replies, patience
        self.end = ""
        self.unsent = self.rest = b""
        self.received: deque[bytes] = deque()
        self.total = self.parts = 0
        self.line_deadline = time.monotonic() + START
        self.deadline = self.line_deadline + LONGEST * max(1.0, patience / USUAL)
        self.selector = selectors.DefaultSelector()
        self.selector.register(replies, selectors.EVENT_READ)
        os.set_blocking(requests, False)

    def send(self, line: bytes) -> None:
        """Queue a line; it is written as soon as the process reads."""
        if not self.unsent:
            self.selector.register(self.requests, selectors.EVENT_WRITE)
        self.unsent += line

    def lines(self) -> Iterator[bytes]:
        """Yield each line as it comes, until the exchange ends."""
        while not self.end:
            while self.received:
                yield self.received.popleft()
            self.wait_for_pipes()
        self.selector.close()

    def wait_for_pipes(self) -> None:
        """Wait until a pipe can be read or written, and do so."""
        ready = [
            key.fd
            for key, _ in self.selector.select(
                max(0.0, min(self.line_deadline, self.deadline) - time.monotonic())
            )
        ]
        if not ready:
            self.end = "late"
        if self.requests in ready:
            self.write_more()
        if self.replies in ready:
            self.read_more(os.read(self.replies, 2**16))

    def write_more(self) -> None:
        """Write what the pipe takes; drop the rest if nobody reads any more."""
        try:
            self.unsent = self.unsent[os.write(self.requests, self.unsent) :]
        except BrokenPipeError:
            self.unsent = b""
        if not self.unsent:
            self.selector.unregister(self.requests)

    def read_more(self, data: bytes) -> None:
        """Split data into lines, and end the exchange if there is too much."""
        self.total += len(data)
        self.parts += sum(map(data.count, (b",", b"[", b"{")))
        *complete, self.rest = (self.rest + data).split(b"\n")
        if complete:
            self.line_deadline = time.monotonic() + self.patience
        self.received.extend(complete)
        if self.total > MOST_OUTPUT or self.parts > MOST_PARTS or len(self.rest) > MOST_LINE:
            self.end = "flood"
        elif not data:
            self.end = "died"
