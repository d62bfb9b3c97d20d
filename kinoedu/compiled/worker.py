"""The process that compiles: python -m kinoedu.compiled.worker FOLDER QUEUE SLOT.

It takes the oldest request of its queue, compiles it, and leaves the machine code in the folder. It
ends when no requests are left, or after its current request if its parent process has ended. Each
slot of a queue has one worker at a time. A request during which a worker was killed is tried again
by the next worker, up to ATTEMPTS times.

A worker of the queue WANTED gives way to other programs. A request that someone waits for does not
come after the many that are compiled ahead, because it has a queue of its own.
"""

import contextlib
import importlib
import os
import pickle
import signal
import sys
import time
from pathlib import Path

from ..support.whole_files import written_whole
from . import store
from .store import (
    PACKAGE,
    UPPER_ROOMS,
    WANTED,
    Request,
    pending_requests,
    slot_file,
    sources,
    try_lock,
    write_request,
)

ATTEMPTS = 3
LINGER = 5.0  # seconds without requests before it ends
POLL_INTERVAL = 0.1  # seconds between two looks for requests
NICE = 10  # the priority of a worker that gives way, by which it still comes to an end
AUTOGROUP = Path("/proc/self/autogroup")  # the priority of this session, see man 7 sched


def main(arguments: list[str]) -> int:
    """Compile the requests in a folder; returns the exit code."""
    place, queue, slot = Path(arguments[0]), arguments[1], arguments[2]
    if queue == WANTED:
        lower_priority()
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(1))
    if store.folder() != place:  # the sources have changed since the request
        return 1
    with contextlib.suppress(FileNotFoundError), open(slot_file(place, queue, slot), "wb") as lock:
        if not try_lock(lock):
            return 0
        taken = place / f"taken-{queue}-{slot}"
        retry_unfinished(place / queue, taken)
        import_compiled_modules()
        compile_requests(place / queue, taken)
    return 0


def lower_priority() -> None:
    """Lower the priority of this process: about a tenth of a processor that others want too.

    Linux may share its processors between sessions first, and then `nice` counts only among the
    processes of one session. This process has a session of its own, whose priority it lowers too.
    """
    if hasattr(os, "nice"):
        os.nice(NICE)
        with contextlib.suppress(OSError):
            if AUTOGROUP.exists():
                AUTOGROUP.write_text(str(NICE), encoding="ascii")
    else:
        import ctypes

        idle = 0x40
        kernel = ctypes.windll.kernel32  # type: ignore[attr-defined]
        kernel.SetPriorityClass(kernel.GetCurrentProcess(), idle)


def retry_unfinished(queue: Path, taken: Path) -> None:
    """Repeat the requests that the last worker did not finish, up to ATTEMPTS times."""
    taken.mkdir(exist_ok=True)
    for file in taken.iterdir():
        with contextlib.suppress(Exception):
            unfinished: Request = pickle.loads(file.read_bytes())
            again = unfinished._replace(attempts=unfinished.attempts + 1)
            if again.attempts < ATTEMPTS:
                write_request(queue, again)
            else:
                write_refusal(queue.parent, again, f"compiling it ended {ATTEMPTS} processes")
        file.unlink(missing_ok=True)


def import_compiled_modules() -> None:
    """Import every module with compiled functions, so that all implementations are registered."""
    without = (*UPPER_ROOMS, "compiled", "__init__.py", "__main__.py", "lab.py", "warm.py")
    for source in sources(PACKAGE, without):
        parts = source.relative_to(PACKAGE.parent).with_suffix("").parts
        importlib.import_module(".".join(parts).removesuffix(".__init__"))


def compile_requests(queue: Path, taken: Path) -> None:
    """Compile until there are no requests for LINGER seconds, or the parent process has ended."""
    parent, last = os.getppid(), time.monotonic()
    while os.getppid() == parent and time.monotonic() < last + LINGER:
        file = take_request(queue, taken)
        if file is None:
            time.sleep(POLL_INTERVAL)
        else:
            compile_request(queue, file)
            last = time.monotonic()


def take_request(queue: Path, taken: Path) -> Path | None:
    """Take the oldest request; None if there is none."""
    for file in pending_requests(queue):
        mine = taken / file.name
        try:
            file.rename(mine)
        except OSError:  # another worker took it
            continue
        if not (queue.parent / f"{file.name}.code").exists():
            return mine
        mine.unlink()
    return None


def compile_request(queue: Path, file: Path) -> None:
    """Compile a request and write its machine code, or the reason why there is none."""
    from .compiler import compile_entry
    from .machine import to_bytes
    from .tiers import find_function

    request: Request = pickle.loads(file.read_bytes())
    try:
        result = compile_entry(find_function(request.module, request.function), request.kinds)
        with written_whole(queue.parent / f"{request.name}.code") as part:
            part.write_bytes(to_bytes(result))
    except (OSError, MemoryError, SystemExit):  # a full disk, say: it was not the request's fault
        file.touch()  # the others come first
        file.replace(queue / file.name)
        raise
    except Exception as error:
        write_refusal(queue.parent, request, f"{type(error).__name__}: {error}")
    file.unlink()


def write_refusal(place: Path, request: Request, why: str) -> None:
    """Write the reason why a request cannot be compiled."""
    with written_whole(place / f"{request.name}.refused") as part:
        part.write_text(why, encoding="utf-8")


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
