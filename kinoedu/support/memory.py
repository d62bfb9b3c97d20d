"""A bound on the memory of this process."""

import threading
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

try:
    import resource
except ImportError:  # Windows
    resource = None  # type: ignore[assignment]

STATUS = Path("/proc/self/statm")  # Linux; its first number is how many pages are mapped


class Bounds:
    """The blocks of all threads that have bounded the memory, and the limits before the first."""

    def __init__(self) -> None:
        self.lock = threading.Lock()
        self.blocks = 0
        self.before = (0, 0)

    def enter(self, most: int) -> None:
        """Bound the memory, unless another block has."""
        with self.lock:
            if not self.blocks:
                self.before = soft, hard = resource.getrlimit(resource.RLIMIT_AS)
                mapped = int(STATUS.read_text().split()[0]) * resource.getpagesize()
                limits = [mapped + most, *(one for one in (soft, hard) if one >= 0)]  # -1: no limit
                resource.setrlimit(resource.RLIMIT_AS, (min(limits), hard))
            self.blocks += 1  # last: a block whose bound could not be set never leaves

    def leave(self) -> None:
        """Put the limits back after the last block."""
        with self.lock:
            self.blocks -= 1
            if not self.blocks:
                resource.setrlimit(resource.RLIMIT_AS, self.before)


BOUNDS = Bounds()


@contextmanager
def bounded_memory(most: int) -> Iterator[None]:
    """Let this process map at most so many bytes more in the block; then MemoryError is raised.

    The bound is for the whole process, and for children that it starts meanwhile. Blocks of several
    threads at a time have the bound of the first. Only Linux has it; elsewhere the block runs
    without a bound.

    Examples
    --------
    >>> with bounded_memory(2**28):
    ...     sum(range(10))
    45
    """
    if resource is None or not STATUS.is_file():
        yield
        return
    BOUNDS.enter(most)
    try:
        yield
    finally:
        BOUNDS.leave()
