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
LONGEST = 300.0  # seconds for the whole exchange
USUAL = 42.0  # patience on a usual computer, in seconds
START = 60.0  # seconds until the first line, on a slow computer


class Talk:
    """Lines to and from a process, through two pipes.

    `end` is how it ended: "late", "flood", or "died" where the process closed its pipe.
    """

    def __init__(self, asking: int, answering: int, patience: float) -> None:
        self.asking, self.answering, self.patience = asking, answering, patience
        self.end = ""
        self.unsaid = self.kept = b""
        self.heard: deque[bytes] = deque()
        self.total = self.parts = 0
        self.last = time.monotonic() + START
        self.very_last = self.last + LONGEST * max(1.0, patience / USUAL)
        self.ready = selectors.DefaultSelector()
        self.ready.register(answering, selectors.EVENT_READ)
        os.set_blocking(asking, False)

    def say(self, line: bytes) -> None:
        """Queue a line; it is written as soon as the process reads."""
        if not self.unsaid:
            self.ready.register(self.asking, selectors.EVENT_WRITE)
        self.unsaid += line

    def lines(self) -> Iterator[bytes]:
        """Yield each line as it comes, until the exchange ends."""
        while not self.end:
            while self.heard:
                yield self.heard.popleft()
            self.listen()
        self.ready.close()

    def listen(self) -> None:
        """Wait until a pipe can be read or written, and do so."""
        able = [
            key.fd
            for key, _ in self.ready.select(
                max(0.0, min(self.last, self.very_last) - time.monotonic())
            )
        ]
        if not able:
            self.end = "late"
        if self.asking in able:
            self.say_more()
        if self.answering in able:
            self.hear_more(os.read(self.answering, 2**16))

    def say_more(self) -> None:
        """Write what the pipe takes; drop the rest if nobody reads any more."""
        try:
            self.unsaid = self.unsaid[os.write(self.asking, self.unsaid) :]
        except BrokenPipeError:
            self.unsaid = b""
        if not self.unsaid:
            self.ready.unregister(self.asking)

    def hear_more(self, data: bytes) -> None:
        """Split data into lines, and end the exchange if there is too much."""
        self.total += len(data)
        self.parts += sum(map(data.count, (b",", b"[", b"{")))
        *whole, self.kept = (self.kept + data).split(b"\n")
        if whole:
            self.last = time.monotonic() + self.patience
        self.heard.extend(whole)
        if self.total > MOST_OUTPUT or self.parts > MOST_PARTS or len(self.kept) > MOST_LINE:
            self.end = "flood"
        elif not data:
            self.end = "died"
