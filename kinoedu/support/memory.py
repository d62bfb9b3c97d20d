"""A bound on the memory of this process."""

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

try:
    import resource
except ImportError:  # Windows
    resource = None  # type: ignore[assignment]

STATUS = Path("/proc/self/statm")  # Linux; its first number is how many pages are mapped


@contextmanager
def bounded_memory(most: int) -> Iterator[None]:
    """Let this process map at most so many bytes more in the block; then MemoryError is raised.

    The bound is for the whole process and its new children. Only Linux has it; elsewhere the block
    runs without a bound.

    Examples
    --------
    >>> with bounded_memory(2**28):
    ...     sum(range(10))
    45
    """
    if resource is None or not STATUS.is_file():
        yield
        return
    soft, hard = resource.getrlimit(resource.RLIMIT_AS)
    mapped = int(STATUS.read_text().split()[0]) * resource.getpagesize()
    bounds = [mapped + most, *(one for one in (soft, hard) if one != resource.RLIM_INFINITY)]
    resource.setrlimit(resource.RLIMIT_AS, (min(bounds), hard))
    try:
        yield
    finally:
        resource.setrlimit(resource.RLIMIT_AS, (soft, hard))
