"""How calls run: the three modes, for a process and for a stretch of it."""

import os
from collections.abc import Iterator
from contextlib import contextmanager

WHEN_IT_PAYS = "when-it-pays"  # interpreted at once, compiled elsewhere when that is cheaper
COMPILED_FIRST = "first"  # whoever times machine code waits for it
INTERPRETED = "never"  # machine code is neither loaded nor made
MODES = (WHEN_IT_PAYS, COMPILED_FIRST, INTERPRETED)


def _mode_of_process() -> str:
    given = os.environ.get("KINOEDU_MACHINE_CODE", WHEN_IT_PAYS)
    return next((known for known in MODES if known == given), WHEN_IT_PAYS)


mode = _mode_of_process()  # read as modes.mode; set by running()


@contextmanager
def running(new: str) -> Iterator[None]:
    """Run the block, in all threads, in another mode.

    >>> from kinoedu import compiled
    >>> from kinoedu.geometry import orientation
    >>> with compiled.running(compiled.INTERPRETED):
    ...     orientation((0, 0), (1, 0), (0, 1))
    1
    """
    global mode
    if new not in MODES:
        raise ValueError(f"a mode is one of {', '.join(MODES)}, got {new!r}")
    before, mode = mode, next(known for known in MODES if known == new)
    try:
        yield
    finally:
        mode = before
