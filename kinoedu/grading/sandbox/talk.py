"""To talk with a process that may say anything, say nothing, never listen, or never end: whatever
it does, this ends in time.
"""

import os
import selectors
import time
from collections import deque
from collections.abc import Iterator

MOST_OUTPUT = 32 * 2**20  # bytes
MOST_PARTS = (
    2**21
)  # commas and brackets, each of which may be a value, and takes far more memory than a byte
MOST_LINE = 2**20
LONGEST = 300.0  # seconds for everything, however much is said
USUAL = 42.0  # seconds of patience on a usual computer
START = 60.0  # seconds until the first line, on a slow machine


class Talk:
    """Lines to and from a process, by two pipes. `end` says how it ended: "late", "flood", or
    "died" where it said no more.
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
        """Have a line said, as soon as there is somebody to read it."""
        if not self.unsaid:
            self.ready.register(self.asking, selectors.EVENT_WRITE)
        self.unsaid += line

    def lines(self) -> Iterator[bytes]:
        """Each line as it comes, until it ends."""
        while not self.end:
            while self.heard:
                yield self.heard.popleft()
            self.listen()
        self.ready.close()

    def listen(self) -> None:
        """Wait until there is more to hear or to say."""
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
        """As much as is taken; nothing more where nobody listens."""
        try:
            self.unsaid = self.unsaid[os.write(self.asking, self.unsaid) :]
        except BrokenPipeError:
            self.unsaid = b""
        if not self.unsaid:
            self.ready.unregister(self.asking)

    def hear_more(self, data: bytes) -> None:
        """Take it for lines, as long as it is not too much."""
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
