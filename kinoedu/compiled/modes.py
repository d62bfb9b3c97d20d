"""The three modes in which calls run, for a process or a block."""

import os
import threading
from collections.abc import Iterator
from contextlib import contextmanager

WHEN_IT_PAYS = (
    "when-it-pays"  # interpreted at once, compiled by another process when that is cheaper
)
COMPILED_FIRST = "first"  # every call waits for its machine code, for measurements of time
INTERPRETED = "never"  # machine code is neither loaded nor made
MODES = (WHEN_IT_PAYS, COMPILED_FIRST, INTERPRETED)


def _mode_of_process() -> str:
    """The mode that KINOEDU_MACHINE_CODE names, or the default."""
    given = os.environ.get("KINOEDU_MACHINE_CODE", WHEN_IT_PAYS)
    return next((name for name in MODES if name == given), WHEN_IT_PAYS)


mode = _mode_of_process()  # read as modes.mode; set by running()
# The mode before the first block, and that of each block: a list of its own, known by identity.
_blocks: list[list[str]] = []
_lock = threading.Lock()


@contextmanager
def running(new: str) -> Iterator[None]:
    """Run the block, in all threads, in another mode: that of the last block that has not ended.

    Raises
    ------
    ValueError
        Where the mode is not known.

    Examples
    --------
    >>> from kinoedu import compiled
    >>> from kinoedu.geometry import orientation
    >>> with compiled.running(compiled.INTERPRETED):
    ...     orientation((0, 0), (1, 0), (0, 1))
    1
    """
    global mode
    if new not in MODES:
        raise ValueError(f"a mode is one of {', '.join(MODES)}, got {new!r}")
    block = [next(name for name in MODES if name == new)]
    with _lock:
        if not _blocks:
            _blocks.append([mode])
        _blocks.append(block)
        mode = block[0]
    try:
        yield
    finally:
        with _lock:
            _blocks[:] = [one for one in _blocks if one is not block]
            mode = _blocks[-1][0]
            if len(_blocks) == 1:
                _blocks.clear()


@contextmanager
def compiled_first() -> Iterator[None]:
    """Run the block in the mode COMPILED_FIRST, or in INTERPRETED where that is the mode now."""
    with running(INTERPRETED if mode is INTERPRETED else COMPILED_FIRST):
        yield
